"""The base of the generated models."""

import pydantic


class BaseModel(pydantic.BaseModel):
    """A model whose validator is made when it is first used: few of a hundred are."""

    model_config = pydantic.ConfigDict(defer_build=True)
