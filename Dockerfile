# gripcourse with everything it needs to lay out documents and to serve a course, which is mounted
# at /course.
#
#   docker build --tag gripcourse .
#   docker run --rm --user "$(id -u):$(id -g)" --volume "$PWD:/course" gripcourse validate

FROM python:3.11-slim-bookworm AS wheel
WORKDIR /source
COPY . .
RUN pip install --no-cache-dir --constraint constraints.txt build hatchling \
 && python -m build --wheel --no-isolation --outdir /wheels

FROM python:3.11-slim-bookworm
COPY scripts/system-packages /usr/local/bin/system-packages
RUN /usr/local/bin/system-packages run \
 && rm -rf /var/lib/apt/lists/* /usr/local/bin/system-packages
COPY constraints.txt /tmp/constraints.txt
COPY --from=wheel /wheels /tmp/wheels
RUN wheel=$(echo /tmp/wheels/*.whl) \
 && pip install --no-cache-dir --constraint /tmp/constraints.txt "$wheel[web,cluster,lti,postgresql]" \
 && rm -rf /tmp/wheels /tmp/constraints.txt \
 && useradd --create-home teacher
USER teacher
# Whoever the container runs as may write what libraries remember.
ENV XDG_CACHE_HOME=/tmp/cache MPLCONFIGDIR=/tmp/cache/matplotlib
WORKDIR /course
ENTRYPOINT ["gripcourse"]
CMD ["--help"]
