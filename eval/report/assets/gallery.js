// SPDX-License-Identifier: BSD-3-Clause
// Pictures open in full size; the arrow keys turn to the next one, Escape closes.

function addGallery() {
  const images = [...document.querySelectorAll('.gallery img, .strip img, .plots img')];
  if (images.length === 0) return;
  const picture = element('img'), caption = element('p');
  const dialog = element('dialog', {}, picture, caption);
  let shown = 0;
  const show = (index) => {
    shown = (index + images.length) % images.length;
    picture.src = images[shown].src;
    picture.alt = images[shown].alt;
    caption.textContent = images[shown].closest('figure').querySelector('figcaption').innerText;
    if (!dialog.open) dialog.showModal();
  };
  const button = (text, onClick) => {
    const made = element('button', {type: 'button', textContent: text});
    made.addEventListener('click', onClick);
    return made;
  };
  dialog.append(element(
      'div', {className: 'controls'}, button('← previous', () => show(shown - 1)),
      button('next →', () => show(shown + 1)), button('close', () => dialog.close())));
  dialog.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowLeft') show(shown - 1);
    if (event.key === 'ArrowRight') show(shown + 1);
  });
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  document.body.append(dialog);
  images.forEach((image, index) => {
    const opener = element('button', {type: 'button', className: 'zoom'});
    opener.setAttribute('aria-label', `Enlarge: ${image.alt}`);
    image.replaceWith(opener);
    opener.append(image);
    opener.addEventListener('click', () => show(index));
  });
}
