import matplotlib.pyplot as plt
import numpy as np

R, k, eta, m = {R}, {k}, {eta}, np.array([[{mA}], [{mB}]])
dt, n = 1e-4, 1000
r, v = np.zeros((n + 1, 2, 2)), np.zeros((n + 1, 2, 2))
r[0], v[0] = [[0, 0], [0.08, 0.018]], [[1.0, 0], [0, 0]]
for i in range(n):
    Dr, Dv = r[i, 1] - r[i, 0], v[i, 1] - v[i, 0]
    d = np.linalg.norm(Dr)
    F = -k * (2 * R - d) ** 1.5 * Dr / d + eta * Dv if d < 2 * R else np.zeros(2)
    v[i + 1] = v[i] + np.array([F, -F]) / m * dt
    r[i + 1] = r[i] + v[i + 1] * dt
t, p = dt * np.arange(n + 1), v * m
figure, axes = plt.subplots(3, 1)
for j, name in enumerate("AB"):
    axes[0].plot(r[:, j, 0], r[:, j, 1], label=name)
    axes[1].plot(t, p[:, j, 0], label=name)
    axes[2].plot(t, p[:, j, 1], label=name)
for axis, x, y in zip(axes, ("x [m]", "t [s]", "t [s]"), ("y [m]", "p_x [kg m/s]", "p_y [kg m/s]")):
    axis.set_xlabel(x)
    axis.set_ylabel(y)
    axis.legend()
plt.show()
