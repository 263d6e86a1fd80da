// A table that is wider than the page scrolls; by keyboard too.
document$.subscribe(() => document.querySelectorAll(".md-typeset__scrollwrap").forEach((each) => { each.tabIndex = 0; }));
