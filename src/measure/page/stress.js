"use strict";
const rows = JSON.parse(document.getElementById("rows").textContent);
const pictures = JSON.parse(document.getElementById("pictures").textContent);

// Text in, elements out: nothing of the rows is ever read as HTML.
function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.filter(Boolean));
  return element;
}
const figure = (name, caption) => (pictures[name]
  ? make("figure", {}, make("img", { src: pictures[name], alt: caption }), make("figcaption", {}, caption)) : null);

const failed = rows.filter((row) => !row.pass).length;
document.getElementById("verdict").textContent = `${rows.length} cases, ${failed ? failed + " fail" : "all pass"}; in ${rows.filter((row) => row.naive_fails).length} the listing as a lecture prints it fails.`;
for (const row of rows) {
  const id = "case-" + row.case, verdict = row.pass ? "pass" : "fail";
  document.getElementById("contents").append(make("li", {}, make("a", { href: "#" + id, class: row.pass ? "" : "bad" }, `${row.case}`)));
  document.getElementById("main").append(make("section", { "aria-labelledby": id },
    make("h2", { id }, `${row.case}. ${row.title} `, make("span", { class: row.pass ? "good" : "bad" }, verdict)),
    make("p", {}, make("strong", {}, "Expected: "), row.expected),
    make("p", {}, make("strong", {}, "The listing: "), row.naive),
    make("p", {}, make("strong", {}, "shadowlab: "), row.ours),
    make("div", { class: "pictures" }, figure(row.naive_picture, "the listing"), figure(row.our_picture, "shadowlab")),
    make("p", { class: "quiet" }, `tests/hard/${row.file}.lua: ${row.facts.join(", ")}`)));
}
document.documentElement.dataset.ready = "yes";
