// SPDX-License-Identifier: BSD-3-Clause
// What the report of a study adds to the style sheet of report.html.
#pragma once

namespace assay::drivers {

inline constexpr const char* study_style = R"css(
:root{--link:#00569a;--name-0:#0066a0}
@media(prefers-color-scheme:dark){:root{--link:#7cc0f5;--series-4:#e6a91f;--series-5:#7cc8f0;--name-0:#5fb0ea;
--name-1:#f59a63;--name-2:#4fd0a6;--name-3:#e9acd0;--name-4:#e6a91f;--name-5:#8ad0f5;--name-6:#bdbdbd}}
a{color:var(--link)}
.question{font-size:1.25rem;line-height:1.35;margin:0 0 16px;color:var(--ink)}
.answer{display:flex;flex-wrap:wrap;align-items:stretch;gap:10px;margin:0 0 16px}
.digit{flex:1 1 150px;background:var(--panel);border-radius:8px;padding:12px 14px;border-top:4px solid var(--bar)}
.digit.missed{border-top-color:var(--line)}
.digit span,.digit small{display:block}.digit .level{color:var(--soft);font-size:.9rem}
.digit b{display:block;font-size:1.7rem;line-height:1.2;font-weight:650;font-variant-numeric:tabular-nums}
.digit .who{font-weight:600;margin-top:4px}.digit small{color:var(--soft);font-size:.8rem}
.step{flex:0 0 auto;align-self:center;text-align:center;font-size:1.35rem;font-weight:650}
.step small{display:block;color:var(--soft);font-size:.75rem;font-weight:400}
figure svg{min-width:600px}
figure,.wide{background:linear-gradient(to right,var(--paper) 30%,transparent) 0 0/36px 100% no-repeat local,
linear-gradient(to left,var(--paper) 30%,transparent) 100% 0/36px 100% no-repeat local,
linear-gradient(to right,rgba(128,128,128,.45),transparent) 0 0/12px 100% no-repeat scroll,
linear-gradient(to left,rgba(128,128,128,.45),transparent) 100% 0/12px 100% no-repeat scroll}
.swipe{display:none;color:var(--soft);font-size:.85rem;margin:0 0 6px}
@media(max-width:900px){.swipe{display:block}}
@media print{.swipe{display:none}figure,.wide{background:none}}
figure.lead svg{max-width:960px;min-width:820px}
figure.map svg{max-width:none;width:auto;height:auto}
.data{margin:4px 0 0;font-size:.85rem;color:var(--soft)}
.question+.answer{margin-bottom:10px}.verdict{padding:7px 14px;margin-bottom:0}.verdict strong{font-size:1rem}
.verdict p{display:inline;margin:0 0 0 12px;font-size:.92rem}.verdict+section h2{margin-top:22px}
.tally{color:var(--soft);margin:0 0 6px}
ul.legend{list-style:none;display:flex;flex-wrap:wrap;gap:4px 20px;margin:6px 0;padding:0;font-size:.9rem}
ul.legend i{display:inline-block;width:26px;height:4px;border-radius:2px;margin-right:8px;vertical-align:middle;
print-color-adjust:exact;-webkit-print-color-adjust:exact}
td.words{white-space:normal;text-align:left;min-width:230px}
tbody th{white-space:normal;min-width:150px}
td.state{white-space:normal;text-align:center;min-width:112px;max-width:190px;padding:6px 8px;
border:2px solid var(--paper);print-color-adjust:exact;-webkit-print-color-adjust:exact}
td.state small{color:inherit}
@media(max-width:520px){.answer{flex-direction:column}.digit{flex:none}.question{font-size:1.1rem}
.step{display:flex;gap:8px;align-items:baseline}.step small{font-size:.85rem}
td.words,tbody th{min-width:0}}
@media print{.wide{overflow:visible}figure{overflow:visible}figure svg,figure.lead svg{min-width:0}table{font-size:9pt}
th,td{white-space:normal;padding-right:8px}td.state,td.words,tbody th{min-width:0}.bar{min-width:40px}
.digit{border:1px solid var(--line);border-top:4px solid #000}a{color:inherit}}
)css";

}  // namespace assay::drivers
