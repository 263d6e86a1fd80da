"use strict";
// Asks twice a second whether a file was saved, and loads the page again: the draw and the place on the page stay.
const header = document.querySelector("[data-edition]"), live = document.querySelector(".live");

async function look() {
  try {
    const answer = await fetch("edition");
    if (answer.ok && await answer.text() !== header.dataset.edition) {
      live.textContent = "· a file was saved: working";
      location.reload();
      return;
    }
    live.textContent = "· follows what is saved";
  } catch (error) {
    live.textContent = "· corollary preview has ended";
  }
  setTimeout(look, 500);
}
look();
