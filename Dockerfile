# Corollary with nbgrader and isolation, for grading where there is no Linux: on Windows, on macOS with every wall, on a server.
#
#   docker build --tag corollary .
#   docker run --rm --interactive --tty --volume "$PWD:/course" corollary doctor
#   docker run --rm --volume "$PWD:/course" corollary grade week1
#
# How well notebooks are shut in depends on the kernel and on docker's own rules: `corollary doctor` says which level holds.
FROM python:3.12-slim

WORKDIR /corollary
COPY . .
RUN python -m venv /opt/corollary
RUN /opt/corollary/bin/python -m pip install --no-cache-dir --constraint .ci/constraints.txt hatchling editables
RUN /opt/corollary/bin/python -m pip install --no-cache-dir --constraint .ci/constraints.txt --no-build-isolation '.[nbgrader,isolation]'
RUN /opt/corollary/bin/corollary --version
RUN /opt/corollary/bin/corollary key X12.5
RUN useradd --create-home --uid 1000 marker

USER marker
ENV PATH=/opt/corollary/bin:$PATH PYTHONUTF8=1
WORKDIR /course
ENTRYPOINT ["corollary"]
CMD ["doctor"]
