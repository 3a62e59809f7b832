// SPDX-License-Identifier: MIT
#pragma once

namespace grader {

// Colours have a contrast of at least 4.5 on their background and differ under every common form of
// colour blindness; each verdict has its sign and word as well.
inline constexpr char kPageStyle[] = R"(
:root { color-scheme: light dark; --text: #1a1a1a; --back: #ffffff; --soft: #f2f3f5; --line: #c9ccd1;
  --pass: #0072b2; --fail: #b34700; --look: #7a5200; --none: #5a6069; }
@media (prefers-color-scheme: dark) {
  :root { --text: #e8e8e8; --back: #16181b; --soft: #22252a; --line: #454a52;
    --pass: #56b4e9; --fail: #ff8a3d; --look: #f0e442; --none: #a7aeb8; } }
body { margin: 0 auto; max-width: 62rem; padding: 1rem; color: var(--text); background: var(--back);
  font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin-bottom: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin-top: 2rem; }
.total { font-size: 2rem; margin: .5rem 0; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .35rem .6rem; overflow-wrap: anywhere;
  border-bottom: 1px solid var(--line); }
thead th { background: var(--soft); overflow-wrap: normal; }
th[scope=row] { min-width: 7rem; } .message, .reason { min-width: 12rem; }
.number { text-align: right; white-space: nowrap; }
.verdict { white-space: nowrap; font-weight: 600; }
.pass { color: var(--pass); } .fail { color: var(--fail); }
.look { color: var(--look); } .none { color: var(--none); }
details { margin: .5rem 0; border: 1px solid var(--line); border-radius: .3rem; }
summary { cursor: pointer; padding: .4rem .6rem; background: var(--soft); }
.evidence { padding: 0 .6rem; }
.scroll { overflow-x: auto; }
.both { display: grid; gap: .2rem; } input[name=lang] + label { margin-right: 1rem; }
#lang-en:checked ~ .both [lang=es], #lang-es:checked ~ .both [lang=en] { display: none; }
.message { white-space: pre-wrap; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; }
dd { margin: 0; overflow-wrap: anywhere; }
code, pre { font-family: ui-monospace, monospace; font-size: .875rem; }
pre { overflow-x: auto; margin: 0; padding: .6rem; }
.maps, .plots { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; }
.map { flex: 1 1 14rem; max-width: 19rem; }
.map svg { display: block; width: 100%; aspect-ratio: 1; }
.map p { margin: .2rem 0; color: var(--none); }
.bar svg { width: 10rem; height: .8rem; vertical-align: middle; }
.plots figure { flex: 1 1 20rem; max-width: 30rem; }
.plot { width: 100%; height: auto; }
@media (prefers-color-scheme: dark) { .plot { filter: brightness(1.4); } }
@media (max-width: 30rem) {
  .stack table, .stack thead, .stack tbody { display: block; }
  .stack tr { display: grid; grid-template-columns: repeat(3, 1fr); border-bottom: 1px solid var(--line); }
  .stack th, .stack td { border: 0; min-width: 0; }
  .stack tr > :last-child { grid-column: 1 / -1; } }
@media print { details, figure, tr { break-inside: avoid; } h2, h3 { break-after: avoid; } }
)";

} // namespace grader
