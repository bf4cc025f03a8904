#!/usr/bin/env bash
# Writes the models of the package anew from the interface document.
#
#     clients/python/scripts/models.sh PYTHON [OUTPUT]
#
# PYTHON has datamodel-code-generator.
set -euo pipefail
python=$(realpath -s "$1")
output=$(realpath -s "${2:-$(dirname "${BASH_SOURCE[0]}")/../brinell/src/brinell/models.py}")
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

"$python" -m datamodel_code_generator --input api/openapi.json --input-file-type openapi --output "$output" \
    --output-model-type pydantic_v2.BaseModel --target-python-version 3.10 --use-annotated --use-standard-collections \
    --use-union-operator --collapse-root-models --enum-field-as-literal all --use-root-model-type-alias --use-schema-description \
    --disable-timestamp --formatters builtin \
    --custom-file-header '# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.'
