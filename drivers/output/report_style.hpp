// SPDX-License-Identifier: BSD-3-Clause
// The style sheet of report.html.
#pragma once

namespace assay::drivers {

inline constexpr const char* report_style = R"css(
:root{color-scheme:light dark;--paper:#fff;--ink:#1b1d20;--soft:#5b626b;--line:#dfe3e8;--panel:#f5f6f8;
--good:#0a6b46;--good-bg:#e3f4ec;--bad:#a3260f;--bad-bg:#fdeae5;--plain-bg:#eef1f5;--bar:#0072b2}
@media(prefers-color-scheme:dark){:root{--paper:#14171b;--ink:#e7e9ec;--soft:#a2aab4;--line:#333a43;--panel:#1d2228;
--good:#6fd8a8;--good-bg:#12312a;--bad:#ff9c85;--bad-bg:#3a1d18;--plain-bg:#232a32;--bar:#56a8e0;
--series-0:#4aa3df;--series-1:#f08a4b;--series-2:#3fc79a;--series-3:#e39bc8;--series-6:#b0b0b0}}
*{box-sizing:border-box}
body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.5 system-ui,-apple-system,"Segoe UI",sans-serif}
main{max-width:1080px;margin:0 auto;padding:24px 20px 60px}
h1{font-size:1.6rem;line-height:1.25;margin:0 0 14px}
h2{font-size:1.15rem;margin:38px 0 10px;padding-bottom:4px;border-bottom:1px solid var(--line)}
.verdict{padding:14px 18px;border-radius:8px;border-left:6px solid;margin-bottom:18px}
.verdict p{margin:4px 0 0;color:var(--ink);overflow-wrap:anywhere}
.verdict strong{font-size:1.15rem}
.good{color:var(--good);background:var(--good-bg)}.bad{color:var(--bad);background:var(--bad-bg)}
.plain{color:var(--ink);background:var(--plain-bg)}
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(134px,1fr));gap:10px;margin:0}
.figures div{background:var(--panel);border-radius:8px;padding:10px 12px}
.figures dt{font-size:.8rem;color:var(--soft)}.figures dd{margin:0;font-size:1.1rem;font-variant-numeric:tabular-nums}
.figures small{display:block;font-size:.78rem;color:var(--soft)}
.wide{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:5px 12px 5px 0;text-align:right;border-bottom:1px solid var(--line);white-space:nowrap}
th:first-child,td:first-child,.left{text-align:left}
thead th{font-weight:600;color:var(--soft);font-size:.85rem}
tbody th{font-weight:400}
th small,td small{display:block;color:var(--soft);font-size:.78rem;font-weight:400}
td.holds{color:var(--good);font-weight:600}td.fails{color:var(--bad);font-weight:600}
figure{margin:0 0 20px;overflow-x:auto}figcaption{color:var(--soft);font-size:.88rem;margin-top:4px}
figure img{display:block;max-width:100%;height:auto;margin:0 auto;background:#fff;border-radius:6px}
figure img.panorama{min-width:680px}
figure svg{display:block;width:100%;min-width:430px;max-width:760px;height:auto;margin:0 auto}
.bar{width:40%;min-width:90px}.bar i{display:block;height:.7em;background:var(--bar);border-radius:2px;min-width:1px}
dl.facts{display:grid;grid-template-columns:max-content 1fr;gap:4px 18px;margin:0}
dl.facts dt{color:var(--soft)}dl.facts dd{margin:0;overflow-wrap:anywhere}
pre{background:var(--panel);padding:14px;border-radius:8px;overflow-x:auto;font:13px/1.45 ui-monospace,monospace;
margin:0;tab-size:2}
@media(max-width:520px){main{padding:16px 12px 40px}dl.facts{grid-template-columns:1fr;gap:0}
dl.facts dd{margin-bottom:8px}h1{font-size:1.3rem}th,td{padding-right:5px;font-size:.75rem;white-space:normal}
thead th{font-size:.72rem}th:last-child,td:last-child{padding-right:0}figure img.panorama,figure svg{min-width:0}.bar{min-width:24px}}
@media print{:root{color-scheme:light;--paper:#fff;--ink:#000;--soft:#444;--line:#bbb;--panel:#f3f3f3;--good:#0a6b46;
--good-bg:#fff;--bad:#a3260f;--bad-bg:#fff;--plain-bg:#fff;--bar:#666}body{font-size:11pt}main{max-width:none;padding:0}
figure,tr,.verdict,.figures div{break-inside:avoid}h2{break-after:avoid}figure img,figure img.panorama{max-height:20cm;min-width:0;width:auto}
pre{white-space:pre-wrap;overflow-wrap:anywhere}.bar i{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
)css";

}  // namespace assay::drivers
