// SPDX-License-Identifier: MIT
#include "report/page.h"

namespace testbed {

const char *const kReportStyle = R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --ink: #202226; --soft: #55585e; --line: #c9ccd1; --band: #f3f4f6;
  --good: #00603f; --bad: #9c2f00; --link: #00538a;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --paper: #17191c; --ink: #e6e7ea; --soft: #a9adb5; --line: #44484f; --band: #22252a;
    --good: #6fd3a6; --bad: #ffa270; --link: #8cc8f5;
  }
  /* The plots are drawn in black on white: turned over, with the hues kept. */
  figure svg { filter: invert(1) hue-rotate(180deg); mix-blend-mode: screen; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body {
  margin: 0 auto; padding: 1.5rem clamp(0.75rem, 3vw, 2.5rem) 3rem; max-width: 80rem;
  background: var(--paper); color: var(--ink);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif;
}
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.5rem 0 1rem; padding-top: 0.75rem; border-top: 2px solid var(--line); }
a { color: var(--link); }
a:focus-visible, .scroll:focus-visible, summary:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
.summary { display: flex; flex-wrap: wrap; gap: 0.75rem; margin: 0 0 1rem; }
.summary div {
  display: flex; flex-direction: column-reverse; justify-content: flex-end; flex: 1 1 11rem;
  padding: 0.6rem 0.9rem; border: 1px solid var(--line); border-left: 4px solid var(--soft); border-radius: 4px;
}
.summary .good { border-left-color: var(--good); }
.summary .bad { border: 3px double var(--bad); }
.summary dt { font-size: 0.85rem; color: var(--soft); }
.summary dd { margin: 0; font-size: 1.6rem; font-weight: 650; line-height: 1.2; }
.setting { margin: 0; font-size: 0.85rem; color: var(--soft); }
nav ul { padding-left: 1.2rem; margin: 1rem 0 0; }
.alarm { margin: 0 0 0.75rem; padding: 0.6rem 0.9rem; border: 3px double var(--bad); overflow-wrap: anywhere; }
.figures { margin-top: 2rem; display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 27rem), 1fr)); gap: 1.5rem; align-items: start; }
figure { margin: 0; min-width: 0; }
figure svg { display: block; width: 100%; min-width: 30rem; height: auto; }
figcaption { font-size: 0.85rem; color: var(--soft); margin-top: 0.3rem; }
.table { margin: 2rem 0 0; }
.scroll { overflow-x: auto; padding-bottom: 0.4rem; }
table { border-collapse: collapse; font-size: 0.85rem; font-variant-numeric: tabular-nums; white-space: nowrap; }
caption { text-align: left; font-weight: 650; font-size: 1rem; padding-bottom: 0.4rem; }
caption span { display: inline-block; position: sticky; left: 0; max-width: calc(100vw - 2.5rem); white-space: normal; }
th, td { padding: 0.2rem 0.6rem; text-align: right; }
th { font-weight: 600; vertical-align: bottom; }
th[scope="row"], thead tr:first-child th:first-child { text-align: left; position: sticky; left: 0; background: var(--paper); }
th[scope="row"] { font-weight: 450; }
thead tr:last-child th, thead th[rowspan] { border-bottom: 2px solid var(--line); }
th.group { text-align: center; border-left: 1px solid var(--line); }
.first { border-left: 1px solid var(--line); }
tbody tr:nth-child(even) > * { background: var(--band); }
.good { color: var(--good); }
.bad { color: var(--bad); font-weight: 700; }
.summary .good, .summary .bad { color: inherit; font-weight: inherit; }
.none { color: var(--soft); }
.legend { margin: 0.35rem 0 0; font-size: 0.8rem; color: var(--soft); }
summary { cursor: pointer; font-size: 0.85rem; color: var(--link); }
details .table { margin-top: 0.5rem; }
footer { font-size: 0.85rem; color: var(--soft); }
footer h2 { color: var(--ink); font-size: 1rem; }
footer li { overflow-wrap: anywhere; }
@page { size: A4; margin: 14mm 12mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 9.5pt; }
  nav, details { display: none; }
  section + section { break-before: page; }
  h2, caption { break-after: avoid; }
  h2 { margin-top: 0; border-top: 0; }
  .figures { margin-top: 5mm; }
  .figures { display: block; }
  figure { break-inside: avoid; margin: 0 0 5mm; }
  figure svg { max-width: 118mm; min-width: 0; margin: 0 auto; }
  figure.wide svg { max-width: 125mm; }
  figcaption { max-width: 165mm; margin: 1mm auto 0; }
  .scroll { overflow: visible; }
  .table { margin-top: 6mm; break-inside: avoid; }
  table { font-size: 7.2pt; line-height: 1.25; width: 100%; }
  caption { font-size: 9.5pt; }
  .legend, figcaption { font-size: 7.5pt; line-height: 1.3; }
  th, td { padding: 0.25mm 1mm; }
  th[scope="row"], thead tr:first-child th:first-child { position: static; background: none; }
  tbody tr:nth-child(even) > * { background: none; }
  tbody tr { border-bottom: 0.2mm solid #ddd; break-inside: avoid; }
}
)css";

} // namespace testbed
