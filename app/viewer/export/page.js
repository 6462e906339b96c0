"use strict";
// Steps of the page, and answers to its questions. The data stand in the element `lesson`.
(function () {
  const lesson = JSON.parse(document.getElementById("lesson").textContent);
  const steps = Array.from(document.querySelectorAll(".step"));
  const where = document.getElementById("where");
  const answers = new Map();
  let now = -1;

  function show(index, fromAddress) {
    const next = Math.max(0, Math.min(steps.length - 1, index));
    if (next === now) return;
    now = next;
    steps.forEach((step, i) => step.classList.toggle("now", i === now));
    document.getElementById("back").disabled = now === 0;
    document.getElementById("next").disabled = now === steps.length - 1;
    where.textContent = (now + 1) + " of " + steps.length + ": " + steps[now].dataset.title;
    const question = questionOf(steps[now]);
    if (question && !question.since) question.since = Date.now();
    if (!fromAddress) {
      try { history.replaceState(null, "", "#" + (now + 1)); } catch (e) { location.hash = "#" + (now + 1); }
    }
    window.scrollTo(0, 0);
  }

  function followAddress() {
    const number = parseInt(location.hash.slice(1), 10);
    show(number >= 1 ? number - 1 : 0, true);
  }

  // ---- questions ----

  function questionOf(step) {
    return lesson.questions.find((each) => each.step === Number(step.dataset.step));
  }
  function nameOf(question, point) {
    const found = Object.entries(question.names).find((each) => each[1] === point);
    return found ? found[0] : String(point);
  }
  function pointOf(question, word) {
    if (Object.prototype.hasOwnProperty.call(question.names, word)) return question.names[word];
    return /^[0-9]+$/.test(word) ? Number(word) : null;
  }
  function words(text) { return text.split(/[\s,]+/).filter((word) => word !== ""); }

  // Reads the form: {given, points | choice | number}; null if nothing valid is given.
  function read(question, form) {
    if (question.kind === "choice") {
      const chosen = form.querySelector("input[type=radio]:checked");
      return chosen ? { given: [chosen.value] } : null;
    }
    const text = form.querySelector(".answer").value.trim();
    if (question.kind === "number") {
      const number = Number(text);
      return text !== "" && isFinite(number) ? { given: [String(number)], number: number } : null;
    }
    const points = words(text).map((word) => pointOf(question, word));
    if (points.includes(null)) return null;
    const set = Array.from(new Set(points)).sort((a, b) => a - b);
    if (question.kind === "point" && set.length !== 1) return null;
    return { given: set.map((point) => nameOf(question, point)), points: set };
  }

  // The grade of an answer, as the program gives it.
  function grade(question, answer) {
    if (question.kind === "choice" || question.kind === "number") {
      const right = question.kind === "choice"
        ? answer.given[0] === question.right.choice
        : Math.abs(answer.number - question.right.number) <= question.within;
      return { right: right, score: right ? 1 : 0, wrong: right ? [] : answer.given, missing: 0 };
    }
    const wrong = answer.points.filter((point) => !question.right.points.includes(point));
    const common = answer.points.length - wrong.length;
    const all = question.right.points.length + wrong.length;
    const right = wrong.length === 0 && common === question.right.points.length;
    const share = all === 0 ? 1 : common / all;
    return {
      right: right, score: question.kind === "point" ? (right ? 1 : 0) : share,
      wrong: wrong.map((point) => nameOf(question, point)),
      without: question.right.points.filter((point) => !answer.points.includes(point)).map((point) => nameOf(question, point)),
      missing: question.right.points.length - common
    };
  }

  function say(form, text) { form.querySelector(".says").textContent = text; }

  function mark(step, question, points, name) {
    step.querySelectorAll("[data-point]").forEach((shape) => {
      if (points.includes(Number(shape.dataset.point))) shape.classList.add(name);
    });
  }
  function markPicked(step, question, form) {
    const points = words(form.querySelector(".answer").value).map((word) => pointOf(question, word));
    step.querySelectorAll(".picked").forEach((shape) => shape.classList.remove("picked"));
    mark(step, question, points, "picked");
  }

  function check(step, question, form) {
    const answer = read(question, form);
    if (!answer) {
      say(form, { choice: "Choose one of the options.", number: "Type a number.", point: "Name one point." }[question.kind] ||
        "Name points, such as " + (Object.keys(question.names)[0] || "12") + ", with commas between them.");
      return;
    }
    const result = grade(question, answer);
    const before = answers.get(question.step) || { tries: 0 };
    const without = question.kind === "points" ? result.without.map((name) => "without " + name) : [];
    answers.set(question.step, {
      step: question.step, title: question.title, kind: question.kind, given: answer.given, wrong: result.wrong,
      right: result.right, score: result.score, seconds: Math.round((Date.now() - question.since) / 100) / 10,
      tries: before.tries + 1, first: before.first || { given: answer.given, mistakes: result.wrong.concat(without) }
    });
    document.getElementById("keep").hidden = false;
    if (result.right) return reveal(step, question, form, "Right. ");
    let text = "Not right.";
    if (result.wrong.length > 0 && question.right.points) text += " Not in the answer: " + result.wrong.join(", ") + ".";
    if (result.missing > 0) text += " Missing: " + result.missing + ".";
    say(form, text + " Try again, or show the answer.");
  }

  function reveal(step, question, form, before) {
    say(form, before + "The answer is " + question.text + "." + (question.reason ? " " + question.reason : ""));
    form.querySelectorAll("button").forEach((button) => { button.disabled = true; });
    const after = step.querySelector(".after");
    if (after) {
      after.hidden = false;
      step.querySelector(".before").hidden = true;
    }
    if (!question.right.points) return;
    const answer = read(question, form);
    const wrong = answer && answer.points ? answer.points.filter((point) => !question.right.points.includes(point)) : [];
    step.querySelectorAll(".picked").forEach((shape) => shape.classList.remove("picked"));
    mark(step, question, question.right.points, "right");
    mark(step, question, wrong, "wrong");
  }

  // The nearest point within reach of a click; null if there is none.
  function pointNear(svg, x, y) {
    let best = null;
    let least = 18;
    svg.querySelectorAll("[data-point]").forEach((shape) => {
      const box = shape.getBoundingClientRect();
      const far = Math.hypot(x - (box.left + box.right) / 2, y - (box.top + box.bottom) / 2);
      if (far < least) {
        least = far;
        best = Number(shape.dataset.point);
      }
    });
    return best;
  }

  function pick(step, question, form, point) {
    const field = form.querySelector(".answer");
    const name = nameOf(question, point);
    const list = words(field.value);
    const at = list.indexOf(name);
    if (at >= 0) list.splice(at, 1); else if (question.kind === "point") list.splice(0, list.length, name); else list.push(name);
    field.value = list.join(", ");
    markPicked(step, question, form);
    say(form, name + (at >= 0 ? " is no longer marked." : " is marked."));
  }

  steps.forEach((step) => {
    const question = questionOf(step);
    const form = step.querySelector(".ask");
    if (!question || !form) return;
    form.addEventListener("submit", (event) => { event.preventDefault(); check(step, question, form); });
    form.querySelector(".show").addEventListener("click", () => reveal(step, question, form, ""));
    if (question.kind !== "points" && question.kind !== "point") return;
    form.querySelector(".answer").addEventListener("input", () => markPicked(step, question, form));
    step.querySelectorAll("svg").forEach((svg) => svg.addEventListener("click", (event) => {
      const point = pointNear(svg, event.clientX, event.clientY);
      if (point !== null && !form.querySelector(".show").disabled) pick(step, question, form, point);
    }));
  });

  function save() {
    const result = { format: "spiraling-edge lesson result", version: 1, lesson: lesson.title, hash: lesson.hash };
    const person = document.getElementById("person").value.trim();
    if (person !== "") result.person = person;
    result.answers = Array.from(answers.values()).sort((a, b) => a.step - b.step);
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([JSON.stringify(result, null, 2) + "\n"], { type: "application/json" }));
    link.download = lesson.name + ".result.json";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  // ---- keys and buttons ----

  const keys = { ArrowRight: 1, PageDown: 1, ArrowLeft: -1, PageUp: -1, Home: -1e9, End: 1e9 };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName)) return;
    if (!(event.key in keys)) return;
    event.preventDefault();
    show(now + keys[event.key]);
  });
  document.getElementById("back").addEventListener("click", () => show(now - 1));
  document.getElementById("next").addEventListener("click", () => show(now + 1));
  document.getElementById("save").addEventListener("click", save);
  window.addEventListener("hashchange", followAddress);
  document.body.classList.add("live");
  document.getElementById("steps").hidden = false;
  followAddress();
})();
