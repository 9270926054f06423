// SPDX-License-Identifier: BSD-3-Clause
// What all scripts of the page share: the data, and the parts around the figures.
'use strict';

const report = {
  data: JSON.parse(document.getElementById('report-data').textContent),
  draw: {},  // a function a kind of plot: (figure, item) draws into the figure
};

// An element with properties and children (elements or texts).
function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// A select of texts; calls back with the index of the chosen one.
function choice(label, texts, chosen, onChange) {
  const select = element('select', {}, ...texts.map((text) => element('option', {textContent: text})));
  select.selectedIndex = chosen;
  select.addEventListener('change', () => onChange(select.selectedIndex));
  return element('label', {}, label, select);
}

function checkbox(label, checked, onChange) {
  const box = element('input', {type: 'checkbox', checked});
  box.addEventListener('change', () => onChange(box.checked));
  return element('label', {}, box, label);
}

// entries: [text, colour, kind]; kind as the style sheet has it: '', 'line', 'line dashed', 'outline'.
function legend(entries) {
  return element('div', {className: 'legend'}, ...entries.map(([text, colour, kind]) => {
    const mark = element('i', {className: kind || ''});
    const entry = element('span', {}, mark, element('b', {textContent: text}));
    entry.style.color = colour;
    return entry;
  }));
}

// A text that follows the pointer while it is over one of the nodes.
const tip = element('div', {className: 'tip', hidden: true});
document.body.append(tip);
function showTip(text) {
  tip.textContent = text;
  tip.hidden = false;
  tip.style.left = `${Math.min(d3.event.clientX + 14, window.innerWidth - 200)}px`;
  tip.style.top = `${d3.event.clientY + 14}px`;
}
function withTip(selection, text) {
  selection.on('mousemove', (item) => showTip(text(item))).on('mouseleave', () => {
    tip.hidden = true;
  });
}

// The switch between the system's scheme, light and dark; figures that cannot follow CSS listen to 'scheme'.
function addThemeSwitch() {
  const themes = ['auto', 'light', 'dark'];
  const button = element('button', {type: 'button', id: 'theme'});
  const show = (theme) => {
    document.documentElement.dataset.theme = theme;
    button.textContent = {auto: '◐ as the system', light: '☀ light', dark: '☾ dark'}[theme];
    button.setAttribute('aria-label', `Colours: ${theme}`);
    document.dispatchEvent(new Event('scheme'));
  };
  button.addEventListener('click', () => {
    const theme = themes[(themes.indexOf(document.documentElement.dataset.theme) + 1) % themes.length];
    try {
      localStorage.setItem('armature-theme', theme);
    } catch (error) { /* not remembered, that is all */
    }
    show(theme);
  });
  let remembered = null;
  try {
    remembered = localStorage.getItem('armature-theme');
  } catch (error) { /* as the system has it */
  }
  show(themes.includes(remembered) ? remembered : 'auto');
  document.querySelector('body > header').append(button);
  matchMedia('(prefers-color-scheme: dark)')
      .addEventListener('change', () => document.dispatchEvent(new Event('scheme')));
}

// What is folded is printed, too.
function unfoldForPrinting() {
  let folded = [];
  window.addEventListener('beforeprint', () => {
    folded = [...document.querySelectorAll('main details:not([open])')];
    folded.forEach((details) => {
      details.open = true;
    });
  });
  window.addEventListener('afterprint', () => folded.forEach((details) => {
    details.open = false;
  }));
}

// Marks the section that is being read.
function followSections() {
  const links = new Map([...document.querySelectorAll('nav a')].map((a) => [a.hash.slice(1), a]));
  const observer = new IntersectionObserver((entries) => {
    for (const {target, isIntersecting} of entries) {
      links.get(target.id).classList.toggle('here', isIntersecting);
    }
  }, {rootMargin: '-20% 0px -75% 0px'});
  document.querySelectorAll('main > section').forEach((section) => observer.observe(section));
}
