# Container with the command codend:
#   docker build -t codend .
#   docker run --rm codend settle midwater_trawl
# Mount a folder for plans and results:
#   docker run --rm -v "$PWD":/data codend settle /data/plan.yaml --out /data/out
FROM debian:trixie
COPY . /src
RUN /src/tools/setup && rm -rf /src
RUN useradd --create-home codend && \
  ln -s "$(Rscript -e 'cat(system.file("exec", "codend", package = "codend"))')" /usr/local/bin/codend
USER codend
WORKDIR /data
ENTRYPOINT ["codend"]
CMD ["--help"]
