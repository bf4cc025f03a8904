# docker build -t brinell .
# docker run --read-only --cap-drop ALL -p 127.0.0.1:8080:8080 -v brinell:/var/lib/brinell -e BRINELL_ALLOW_ANONYMOUS=true brinell

FROM rust:1.95-slim-bookworm AS build
WORKDIR /build
# The libraries by themselves: this layer lasts until Cargo.lock changes.
COPY Cargo.toml Cargo.lock ./
COPY crates/brinell-contact/Cargo.toml crates/brinell-contact/
COPY crates/brinell-halfspace/Cargo.toml crates/brinell-halfspace/
COPY crates/brinell-fem/Cargo.toml crates/brinell-fem/
COPY crates/brinell-material/Cargo.toml crates/brinell-material/
COPY crates/brinell-method/Cargo.toml crates/brinell-method/
COPY crates/brinell-solver/Cargo.toml crates/brinell-solver/
COPY crates/dense-cholesky/Cargo.toml crates/dense-cholesky/
COPY crates/sparse-cholesky/Cargo.toml crates/sparse-cholesky/
COPY tools/Cargo.toml tools/
# A stand-in for every target that a manifest names.
RUN for package in . crates/* tools; do \
      mkdir -p $package/src && touch $package/src/lib.rs \
      && for kind in bench:benches example:examples test:tests bin:src/bin; do \
        folder=$package/${kind#*:} && mkdir -p $folder \
        && for name in $(sed -n "/^\[\[${kind%:*}\]\]/{n;s/name = \"\(.*\)\"/\1/p}" $package/Cargo.toml); do \
          echo 'fn main() {}' > $folder/$name.rs; \
        done; \
      done; \
    done \
 && echo 'fn main() {}' > src/main.rs \
 && cargo build --profile dist --locked --bin brinell \
 && rm -r src crates tests tools
COPY api api
COPY crates crates
COPY migrations migrations
COPY src src
COPY tests tests
COPY tools tools
COPY web web
# Copied files keep their times, and cargo goes by those.
RUN touch src/lib.rs src/main.rs crates/*/src/lib.rs && cargo build --profile dist --locked --bin brinell && mkdir /data

FROM python:3.13-slim-bookworm AS guide
WORKDIR /build
COPY README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md ./
COPY api/examples api/examples
COPY clients/python clients/python
COPY docs docs
COPY scripts/site.sh scripts/
RUN scripts/site.sh /guide

FROM debian:bookworm-slim
ARG VERSION=0.3.0
LABEL org.opencontainers.image.title="brinell" \
      org.opencontainers.image.description="Elasto-plastic contact between two bodies as an HTTP service" \
      org.opencontainers.image.version="${VERSION}" \
      org.opencontainers.image.licenses="MIT OR Apache-2.0"
COPY --from=build /build/target/dist/brinell /usr/local/bin/brinell
COPY LICENSE-MIT LICENSE-APACHE /usr/share/doc/brinell/
COPY --from=guide /guide /usr/share/doc/brinell/guide
# A number, so that an orchestrator can see that it is not root.
COPY --from=build --chown=10001:10001 /data /var/lib/brinell
USER 10001:10001
ENV BRINELL_LISTEN=0.0.0.0:8080 \
    BRINELL_DATA_DIR=/var/lib/brinell \
    BRINELL_GUIDE=/usr/share/doc/brinell/guide \
    BRINELL_LOG_FORMAT=json
VOLUME /var/lib/brinell
EXPOSE 8080
STOPSIGNAL SIGTERM
HEALTHCHECK --interval=10s --timeout=3s --start-period=5s CMD ["/usr/local/bin/brinell", "healthcheck"]
ENTRYPOINT ["/usr/local/bin/brinell"]
CMD ["serve"]
