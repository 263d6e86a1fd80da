"""Students' programs and figures judged: convergence with the step, curves, labels and panels; what each exercise asks for stands in its bank."""
