"""The work-precision study of the trade between speed and accuracy; the race on the chapter's scenes is `corollary.trade`."""
