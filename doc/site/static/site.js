// Equations of a page, by KaTeX
for (const place of document.querySelectorAll(".math"))
    katex.render(place.textContent, place, {displayMode: place.tagName === "DIV"});
