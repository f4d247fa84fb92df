// The site's search where its pages are opened from a disk: browsers let no page of a disk read
// search_index.json or start a worker, so packaging/site.sh leaves the same index as a script.
"use strict";

(function () {
  if (window.location.protocol !== "file:") return; // the theme's own search serves
  window.Worker = function () { this.postMessage = function () {}; }; // the theme's would only fail
  const MOST = 40, AROUND = 120; // results; characters of text either side of a word

  function wordsOf(text) {
    return text.toLowerCase().split(/\s+/).filter(Boolean);
  }

  // Sections that hold all words, those with them in the title first.
  function found(sections, words) {
    const held = sections.filter(function (s) {
      const all = (s.title + " " + s.text).toLowerCase();
      return words.every(function (w) { return all.includes(w); });
    });
    function rank(s) {
      const title = s.title.toLowerCase();
      return words.filter(function (w) { return title.includes(w); }).length;
    }
    return held.sort(function (a, b) { return rank(b) - rank(a); }).slice(0, MOST);
  }

  function summary(section, word) {
    const at = Math.max(section.text.toLowerCase().indexOf(word), 0);
    const from = Math.max(at - AROUND, 0);
    return (from ? "… " : "") + section.text.slice(from, at + AROUND) + " …";
  }

  function show(place, sections, words) {
    place.replaceChildren();
    if (!sections.length) place.append("No results found");
    for (const section of sections) {
      const article = document.createElement("article"), head = document.createElement("h3");
      const link = document.createElement("a"), text = document.createElement("p");
      link.href = window.base_url + "/" + section.location;
      link.textContent = section.title;
      text.textContent = summary(section, words[0]);
      head.append(link);
      article.append(head, text);
      place.append(article);
    }
  }

  document.addEventListener("DOMContentLoaded", function () {
    const place = document.getElementById("mkdocs-search-results");
    const input = document.getElementById("mkdocs-search-query");
    if (!place || !input) return; // not the page of results
    const index = document.createElement("script");
    index.src = window.base_url + "/search/index_on_disk.js";
    index.onload = function () {
      function search() {
        const words = wordsOf(input.value);
        show(place, words.length ? found(window.glovetrackIndex.docs, words) : [], words);
      }
      input.addEventListener("keyup", search);
      input.value = new URLSearchParams(window.location.search).get("q") || "";
      search();
    };
    document.body.append(index);
  });
})();
