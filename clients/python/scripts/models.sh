#!/usr/bin/env bash
# Writes the models of the package anew from the interface document: `models.py` of jobs,
# `reports.py` of results, which most programs never load.
#
#     clients/python/scripts/models.sh PYTHON [FOLDER]
#
# PYTHON has datamodel-code-generator.
set -euo pipefail
python=$(realpath -s "$1")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
folder=$(realpath -s "${2:-$here/../brinell/src/brinell}")
document=$(mktemp --suffix .json)
trap 'rm -f "$document"' EXIT

write() {
    "$python" "$here/schemas.py" "${@:2}" >"$document"
    "$python" -m datamodel_code_generator --input "$document" --input-file-type openapi --output "$folder/$1" \
        --output-model-type pydantic_v2.BaseModel --base-class brinell._model.BaseModel --target-python-version 3.10 --use-annotated \
        --use-standard-collections --use-union-operator --collapse-root-models --enum-field-as-literal all \
        --use-root-model-type-alias --use-schema-description --disable-timestamp --formatters builtin \
        --custom-file-header '# Generated from api/openapi.json by clients/python/scripts/models.sh; do not edit.'
}

write models.py ContactJob TestedCurve PrescribedForce PrescribedApproach
write reports.py Report
