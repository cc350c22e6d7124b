"use strict";
const report = JSON.parse(document.getElementById("report").textContent);
const pictures = JSON.parse(document.getElementById("pictures").textContent);
const main = document.getElementById("main");
const measured = report.points.filter((p) => !p.left_out);
const scenes = report.options.scenes;

// Text in, elements out: nothing of the report is ever read as HTML.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

const digits = (x, n = 3) => (x === null || x === undefined ? "" : x === 0 ? "0"
  : x >= 1e4 ? Math.round(x).toLocaleString("en") : Number(x.toPrecision(n)).toString());
const mebibytes = (bytes) => digits(bytes / 2 ** 20);
const settingsOf = (p) => Object.entries(p.settings).map(([k, v]) => `${k}=${v}`).join(" ")
  + (p.planned ? " planned" : "");
const labelOf = (p) => [p.recipe, settingsOf(p)].filter(Boolean).join(" ");
const errorText = (p) => (p.error.below_bar ? "≤ " : "") + digits(p.error.rmse);

function table(caption, columns, rows) {
  const head = columns.map(([name, kind]) => make("th", { scope: "col", class: kind ?? "" }, name));
  const body = rows.map((row) => make("tr", {}, ...row.map((cell, i) =>
    make("td", { class: columns[i][1] ?? "" }, cell instanceof Node ? cell : String(cell ?? "")))));
  return make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    make("table", {}, make("caption", {}, caption),
      make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...body)));
}

function section(id, title, ...content) {
  document.getElementById("contents").append(make("li", {}, make("a", { href: "#" + id }, title)));
  const made = make("section", { "aria-labelledby": id }, make("h2", { id }, title), ...content);
  main.append(made);
  return made;
}

// Colours that are told apart on both grounds, and shapes for who tells no colours.
const recipes = [...new Set(measured.map((p) => p.recipe))].sort();
const shapes = ["circle", "triangle", "rect", "rectRot", "star", "cross", "crossRot", "rectRounded"];
const colorOf = (recipe) => `hsl(${(recipes.indexOf(recipe) * 137.5) % 360} 62% ${dark() ? 66 : 40}%)`;
const shapeOf = (recipe) => shapes[recipes.indexOf(recipe) % shapes.length];

// Paper is light whatever the screen is.
let printing = false;
const darkScreen = window.matchMedia("(prefers-color-scheme: dark)");
const dark = () => !printing && darkScreen.matches;
const ink = () => (dark() ? "#e4e7ea" : "#1d2126");
const faint = () => (dark() ? "#343a42" : "#dcdfe3");
const charts = [];
function redraw() {
  for (const { chart, colors } of charts) { colors(chart); chart.update("none"); }
}
darkScreen.addEventListener("change", redraw);
window.addEventListener("beforeprint", () => { printing = true; redraw(); for (const { chart } of charts) chart.resize(); });
window.addEventListener("afterprint", () => { printing = false; redraw(); });

function axis(title, options = {}) {
  return { type: "logarithmic", title: { display: Boolean(title), text: title },
           ticks: { maxTicksLimit: 8, autoSkip: true, callback: (v) => {
             const lead = v / 10 ** Math.floor(Math.log10(v) + 1e-9);
             return [1, 2, 5].some((d) => Math.abs(d - lead) < 1e-6) ? digits(v) : "";
           } }, ...options };
}

function plot(canvas, datasets, x, y, options = {}) {
  const colors = (chart) => {
    for (const scale of Object.values(chart.options.scales)) {
      scale.ticks.color = ink(); scale.title.color = ink(); scale.grid = { color: faint() };
    }
    if (chart.options.plugins.legend.labels) chart.options.plugins.legend.labels.color = ink();
    for (const dataset of chart.data.datasets) {
      const color = dataset.recipe ? colorOf(dataset.recipe) : dataset.front ? ink() : faint();
      dataset.borderColor = color;
      dataset.backgroundColor = dataset.hollow
        ? dataset.data.map((point) => (point.hollow ? "transparent" : color)) : color;
    }
  };
  const chart = new Chart(canvas, {
    type: "scatter", data: { datasets },
    options: { animation: false, responsive: true, maintainAspectRatio: false, scales: { x, y },
               plugins: { legend: { display: false } }, ...options },
  });
  colors(chart);
  chart.update("none");
  charts.push({ chart, colors });
  return chart;
}

// Where an error of 0 is drawn on a logarithmic axis: half of the least that a picture can show.
function leastError(points) {
  const some = points.map((p) => p.error.rmse).filter((e) => e > 0);
  return some.length ? Math.min(...some) / 2 : 1e-3;
}
const placeOf = (p, least) => ({ x: p.frame_ms.median, y: Math.max(p.error.rmse, least), point: p,
                                 hollow: p.error.below_bar || p.error.rmse === 0 });

function front(points) {
  const sorted = [...points].sort((a, b) => a.frame_ms.median - b.frame_ms.median || a.error.rmse - b.error.rmse);
  const kept = [];
  for (const p of sorted) if (!kept.length || p.error.rmse < kept[kept.length - 1].error.rmse) kept.push(p);
  return kept;
}

function picture(name, caption) {
  return pictures[name]
    ? make("figure", {}, make("img", { src: pictures[name], alt: caption }), make("figcaption", {}, caption)) : null;
}

function describe(panel, p) {
  const error = p.error;
  panel.replaceChildren(
    make("strong", {}, labelOf(p)), ` in ${p.scene}: ${p.title}`,
    make("p", {}, `${digits(p.frame_ms.median)} ms a frame (quartiles ${digits(p.frame_ms.q1)} and ${digits(p.frame_ms.q3)}, ${p.frame_ms.count} frames). `
      + `RMSE ${errorText(p)}, 99 % of ${error.pixels} pixels within ${digits(error.p99)}`
      + (p.on_receivers ? ", on receivers alone" : "") + `. Wrong pixels ${error.wrong}, beyond an edge ${error.wrong_beyond_edge}. `
      + `RMSE in the umbra ${digits(error.umbra_rmse) || "–"}, the penumbra ${digits(error.penumbra_rmse) || "–"}, the light ${digits(error.lit_rmse) || "–"}. `
      + (error.worst > 0 ? `Worst pixel at ${error.worst_x}, ${error.worst_y}: off by ${digits(error.worst)}. ` : "No pixel is off. ")
      + `FLIP ${digits(p.flip_mean)} on average, ${digits(p.flip_worst)} at worst.`),
    make("div", { class: "pictures" },
      picture(p.pictures.visibility, "what the technique says"),
      picture(p.pictures.truth, "the truth"),
      picture(p.pictures.error, "how far they are apart")));
}

// A plot whose points can be walked along with the arrow keys, from the fastest to the slowest.
function walkable(points, label) {
  const least = leastError(points);
  const panel = make("div", { class: "chosen", "aria-live": "polite" },
    make("span", { class: "quiet" }, "Hollow: no error that can be told from 0. Choose a point: click it, or focus the plot and press the arrow keys."));
  const canvas = make("canvas", { tabindex: "0", role: "img", "aria-label": label });
  const named = recipes.filter((recipe) => points.some((p) => p.recipe === recipe));
  const datasets = named.map((recipe) => ({
    label: recipe, recipe, hollow: true, pointStyle: shapeOf(recipe), pointRadius: 6, pointHoverRadius: 8, borderWidth: 1.5,
    data: points.filter((p) => p.recipe === recipe).map((p) => placeOf(p, least)),
  }));
  datasets.push({ label: "Pareto front", front: true, type: "line", pointRadius: 0, pointHitRadius: 0, borderWidth: 1.5,
                  stepped: "before", data: front(points).map((p) => placeOf(p, least)) });
  const frame = make("div", { class: "chart" }, canvas);
  const chart = () => plot(canvas, datasets, axis("milliseconds a frame"), axis("RMSE of visibility"), {
    plugins: {
      legend: { display: window.innerWidth > 600, position: "right", labels: { usePointStyle: true, boxWidth: 8, font: { size: 11 } } },
      tooltip: { callbacks: { label: (item) => {
        const p = item.raw.point;
        return [labelOf(p), `${digits(p.frame_ms.median)} ms, RMSE ${errorText(p)}`];
      } } },
    },
    onClick: (event, hits) => { if (hits.length) choose(datasets[hits[0].datasetIndex].data[hits[0].index].point); },
  });
  const order = [...points].sort((a, b) => a.frame_ms.median - b.frame_ms.median);
  let at = -1;
  const choose = (p) => { at = order.indexOf(p); describe(panel, p); };
  canvas.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    choose(order[Math.min(Math.max(at + step, 0), order.length - 1)]);
  });
  return { frame, panel, chart, choose };
}

function multiples(points) {
  const least = leastError(points);
  const grid = make("div", { class: "small" });
  const waiting = [];
  const xs = points.map((p) => p.frame_ms.median), ys = points.map((p) => Math.max(p.error.rmse, least));
  const x = { min: Math.min(...xs) * 0.8, max: Math.max(...xs) * 1.25 }, y = { min: Math.min(...ys) * 0.8, max: Math.max(...ys) * 1.25 };
  for (const recipe of recipes.filter((name) => points.some((p) => p.recipe === name))) {
    const own = points.filter((p) => p.recipe === recipe);
    const canvas = make("canvas", { role: "img", "aria-label": `${recipe}: ${own.length} points` });
    grid.append(make("figure", {}, make("div", { class: "chart" }, canvas), make("figcaption", {}, `${recipe}: ${own[0].title}`)));
    waiting.push(() => plot(canvas, [
      { recipe, pointStyle: shapeOf(recipe), pointRadius: 4, data: own.map((p) => placeOf(p, least)) },
      { pointRadius: 2, pointHitRadius: 0, data: points.filter((p) => p.recipe !== recipe).map((p) => placeOf(p, least)) },
    ], axis("", x), axis("", y), { plugins: { legend: { display: false }, tooltip: { callbacks: { label: (item) => labelOf(item.raw.point) } } } }));
  }
  return { grid, draw: () => waiting.forEach((one) => one()) };
}

function pointButton(p, choose) {
  return make("button", { class: "point", type: "button", onclick: () => choose(p) }, labelOf(p));
}

const thresholds = [[1 / 255, "1/255"], [0.01, "1 %"], [0.05, "5 %"]];
const choosers = new Map();

function summary() {
  const rows = [];
  for (const scene of scenes) {
    for (const truth of ["hard", "soft"]) {
      const points = measured.filter((p) => p.scene === scene && p.truth === truth && !p.planned);
      if (!points.length) continue;
      rows.push([scene, truth, ...thresholds.map(([limit]) => {
        const best = points.filter((p) => p.error.rmse <= limit).sort((a, b) => a.frame_ms.median - b.frame_ms.median)[0];
        return best ? `${labelOf(best)}: ${digits(best.frame_ms.median)} ms, RMSE ${errorText(best)}` : "none";
      })]);
    }
  }
  section("fastest", "Fastest technique under an error",
    make("p", { class: "quiet" }, "The error is the RMSE of visibility over all compared pixels of a picture. FLIP, in the tables below, compares final pictures with the ray-traced one in the same light, and so counts what a recipe colours otherwise too. A frame is one of many under a still light: what a recipe keeps from frame to frame (the maps of shadow_map_cube and shadow_map_exact, unless told otherwise) is made in the first, which is not timed."),
    table("The fastest point whose RMSE is at most…", [["scene"], ["light"], ...thresholds.map(([, name]) => [name])], rows));
}

function scenePlots() {
  for (const scene of scenes) {
    const parts = [], drawn = [];
    for (const truth of ["hard", "soft"]) {
      const points = measured.filter((p) => p.scene === scene && p.truth === truth && !p.planned);
      if (!points.length) continue;
      const title = truth === "hard" ? "A light without size" : `A light of radius ${report.options.radius}`;
      const { frame, panel, chart, choose } = walkable(points, `${scene}, ${title}: error against milliseconds, ${points.length} points; the table below has the same`);
      choosers.set(scene + truth, choose);
      const small = multiples(points);
      drawn.push(chart, small.draw);
      parts.push(make("h3", {}, title), frame, panel,
        table(`The Pareto front in ${scene}: no other point is both faster and nearer to the truth`,
          [["point"], ["ms", "n"], ["q1", "n"], ["q3", "n"], ["RMSE", "n"], ["99 %", "n"], ["umbra", "n"], ["penumbra", "n"], ["beyond edge", "n"], ["FLIP", "n"]],
          front(points).map((p) => [pointButton(p, choose), digits(p.frame_ms.median), digits(p.frame_ms.q1), digits(p.frame_ms.q3), errorText(p),
            digits(p.error.p99), digits(p.error.umbra_rmse), digits(p.error.penumbra_rmse), p.error.wrong_beyond_edge, digits(p.flip_mean)])),
        make("h3", {}, "By technique"), small.grid);
    }
    section("scene-" + scene, "Scene " + scene, ...parts);
    drawn.forEach((draw) => draw());
  }
}

function curves() {
  if (!report.curves?.length) return;
  const grid = make("div", { class: "small" });
  const rows = report.curves.map((c) => [c.recipe, c.scene, c.of, c.exponent === null ? "–" : digits(c.exponent, 3),
    c.explained === null ? "" : digits(100 * c.explained, 3) + " %", c.points.map((p) => `${digits(p.x)}: ${digits(p.ms)}`).join(", ")]);
  section("curves", "Cost curves", make("p", { class: "quiet" },
    "Time grows as the given power of what is varied; the share of the variance of log time that this explains is beside it. Other parameters are the recipe's own."),
    grid, table("milliseconds ~ value ^ exponent", [["recipe"], ["scene"], ["of"], ["exponent", "n"], ["explained", "n"], ["value: ms"]], rows));
  for (const of of [...new Set(report.curves.map((c) => c.of))]) {
    const canvas = make("canvas", { role: "img", "aria-label": `milliseconds against ${of}` });
    grid.append(make("figure", {}, make("div", { class: "chart" }, canvas), make("figcaption", {}, `milliseconds against ${of}`)));
    plot(canvas, report.curves.filter((c) => c.of === of).map((c) => ({
      label: `${c.recipe} ${c.scene}`, recipe: c.recipe, type: "line", borderWidth: 1, pointRadius: 2, pointStyle: shapeOf(c.recipe),
      data: c.points.map((p) => ({ x: p.x, y: p.ms })),
    })), axis(""), axis(""), { plugins: { legend: { display: false }, tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${digits(item.raw.y)} ms` } } } });
  }
}

function passes() {
  const rows = [];
  for (const p of measured.filter((q) => !Object.keys(q.settings).length && !q.planned)) {
    for (const pass of p.passes.filter((q) => q.ms.median > 0)) {
      rows.push([p.scene, p.recipe, pass.name, pass.count, digits(pass.ms.median), digits(pass.mpix), pass.triangles.toLocaleString("en"),
        pass.fill_limit_ms > 0 ? digits(pass.ms.median / pass.fill_limit_ms) : "", digits(pass.ms.median / pass.limit_ms)]);
    }
  }
  section("passes", "Passes against the fill limit",
    make("p", { class: "quiet" }, "The fill limit of a pass is the least time that its pixels take on this machine; with its triangles and the price of a pass it is the limit in all. Recipes with their own parameters; passes of a map that is kept from the first frame on are left out."),
    make("details", {}, make("summary", {}, `${rows.length} passes`), table("times over their limits",
      [["scene"], ["recipe"], ["pass"], ["times", "n"], ["ms", "n"], ["Mpix", "n"], ["triangles", "n"], ["over fill", "n"], ["over all", "n"]], rows)));
}

function plans() {
  const rows = [];
  for (const planned of measured.filter((p) => p.planned)) {
    const whole = measured.find((p) => p.scene === planned.scene && p.recipe === planned.recipe && !p.planned && !Object.keys(p.settings).length);
    if (!whole) continue;
    const pair = (get, show = digits) => `${show(get(whole))} → ${show(get(planned))}`;
    rows.push([whole.scene, whole.recipe, pair((p) => p.frame_ms.median), digits(whole.frame_ms.median / planned.frame_ms.median) + "×",
      pair((p) => p.mpix), pair((p) => p.triangles), pair((p) => p.passes.reduce((n, pass) => n + pass.count, 0)),
      pair((p) => p.upload_bytes, mebibytes), pair((p) => p.gl_bytes, mebibytes),
      planned.error.rmse === whole.error.rmse ? "0" : digits(planned.error.rmse - whole.error.rmse)]);
  }
  section("plan", "Only what a scene needs", make("p", { class: "quiet" },
    "Each recipe with all casters, and with those alone whose shadows can reach what is seen (shadow.plan). A difference of 0 is exact."),
    table("all casters → planned", [["scene"], ["recipe"], ["ms"], ["faster", "n"], ["Mpix"], ["triangles"], ["passes"], ["MiB sent"], ["MiB held"], ["RMSE", "n"]], rows));
}

function truths() {
  const content = [make("p", {}, "A hard truth is exact. A soft one is traced with as many samples in each pixel as its error bar asks; "
    + "no error below the bar is reported as one: it stands at the bar, marked ≤."),
  table("The truths of this report", [["scene"], ["radius", "n"], ["error bar", "n"], ["rays", "n"], ["million rays/s", "n"], ["pixels above the bar", "n"]],
    report.truths.map((t) => [t.scene, t.radius, t.bar === 0 ? "0" : digits(t.bar), t.rays.toLocaleString("en"), digits(t.rays / t.milliseconds / 1000), t.unconverged])),
  table("How the bar was checked: traced shadows against closed forms, in their penumbrae", [["shadow"], ["pixels", "n"], ["bar", "n"], ["RMSE", "n"], ["within one", "n"], ["within three", "n"], ["worst", "n"], ["samples", "n"], [""]],
    report.bar_check.map((c) => [c.shadow, c.pixels, digits(c.bar), digits(c.rmse), digits(100 * c.within_one) + " %", digits(100 * c.within_three) + " %", digits(c.worst), digits(c.samples),
      make("span", { class: c.holds ? "good" : "bad" }, c.holds ? "holds" : "does not hold")]))];
  section("truth", "The truth and its error bars", ...content);
}

function everything() {
  section("all", "All points", make("details", {}, make("summary", {}, `${report.points.length} points`),
    table("every point", [["scene"], ["point"], ["ms", "n"], ["RMSE", "n"], ["99 %", "n"], ["wrong", "n"], ["beyond edge", "n"], ["FLIP", "n"], ["triangles", "n"], ["Mpix", "n"], ["MiB held", "n"], ["MiB peak", "n"]],
      report.points.map((p) => (p.left_out
        ? [p.scene, `${labelOf(p)}: left out, ${p.left_out}`]
        : [p.scene, p.planned ? labelOf(p) : pointButton(p, (q) => { choosers.get(q.scene + q.truth)(q); document.getElementById("scene-" + q.scene).scrollIntoView(); }),
           digits(p.frame_ms.median), errorText(p), digits(p.error.p99), p.error.wrong, p.error.wrong_beyond_edge, digits(p.flip_mean),
           p.triangles.toLocaleString("en"), digits(p.mpix), mebibytes(p.gl_bytes), mebibytes(p.peak_bytes)])))));
}

function header() {
  const m = report.machine, limit = report.fill_limit;
  document.getElementById("machine").textContent =
    `${m.processor}, ${m.cores} cores, ${digits(m.memory_bytes / 2 ** 30)} GiB; ${m.system}; ${m.context}, ${m.renderer}, ${m.driver}; threads of the driver: ${m.driver_threads}; load ${digits(m.load)}. `
    + `Pictures of ${report.options.width} × ${report.options.height}, ${report.options.rounds} rounds. A layer of 1 Mpix costs `
    + Object.entries(limit.ms_per_mpix).map(([name, ms]) => `${digits(ms)} ms of ${name}`).join(", ")
    + `; a triangle ${digits(limit.ns_per_triangle)} ns, a pass ${digits(limit.ms_per_pass)} ms. shadowlab ${m.shadowlab}, ${m.when}.`;
}

header();
summary();
scenePlots();
curves();
passes();
plans();
truths();
everything();
document.documentElement.dataset.ready = "yes";
