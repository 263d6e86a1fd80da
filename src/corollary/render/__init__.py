"""Output for people: pages, paper, the terminal; one file a target."""
