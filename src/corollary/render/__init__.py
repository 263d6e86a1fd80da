"""What a person looks at: pages, paper, the terminal; one file a target."""
