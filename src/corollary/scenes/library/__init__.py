"""The chapter's scenes, one a file: a file here is a scene of its name and holds it as SCENE."""
