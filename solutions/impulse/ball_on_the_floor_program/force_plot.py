import matplotlib.pyplot as plt

m, k, R, g = {m}, {k}, {R}, {g}
y, v, dt, touched, after = {y0}, {v0}, 1e-5, False, 0
t, F, p = [], [], []
while after < 50:
    squeezed = max(R - y, 0.0)
    touched = touched or squeezed > 0
    after += touched and squeezed == 0
    t.append(len(t) * dt)
    F.append(k * squeezed**1.5 - m * g)
    p.append(m * v)
    v = v + F[-1] / m * dt
    y = y + v * dt
figure, (above, below) = plt.subplots(2, 1, sharex=True)
above.plot(t, F)
above.set_xlabel("t [s]")
above.set_ylabel("F [N]")
below.plot(t, p)
below.set_xlabel("t [s]")
below.set_ylabel("p [kg m/s]")
plt.show()
