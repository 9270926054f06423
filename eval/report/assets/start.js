// SPDX-License-Identifier: BSD-3-Clause
// Brings the page to life.

addThemeSwitch();
followSections();
unfoldForPrinting();
makeTablesSortable();
addGallery();
for (const figure of document.querySelectorAll('[data-plot]')) {
  const {plot, index} = figure.dataset;
  report.draw[plot](figure, report.data[plot][index]);
}
