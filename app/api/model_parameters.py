"""Which models a query asks for, and their own parameters, spelled `<model>.<parameter>`."""

import inspect
from collections import Counter
from collections.abc import Callable, Sequence
from copy import copy
from typing import Annotated, Any, ClassVar, Literal, TypeVar, get_args

import numpy as np
from numpy.typing import ArrayLike
from pydantic import (
    BeforeValidator,
    Field,
    TypeAdapter,
    ValidationError,
    WithJsonSchema,
    create_model,
)
from pydantic_core import PydanticCustomError

from app.answers.curves import Chosen
from app.api.params import number
from app.http.problems import BadParameters, ParameterError
from app.http.query import Count, Number, QueryModel
from app.optics.errors import NotAllowed
from app.optics.parameters import Parameter
from app.optics.registry import Model, Registry

T = TypeVar("T")
Endpoint = TypeVar("Endpoint", bound=Callable[..., Any])

_ANY_MODELS = "Comma-separated ids of models, as listed at /models."

ModelsParameter = Annotated[str, Field(description=_ANY_MODELS, examples=["exact,schlick"])]
ModelId = Annotated[str, Field(description="Id of a model, as listed at /models.")]

_NUMBER: TypeAdapter[float] = TypeAdapter(Number)
_THREE = {"type": "string", "pattern": "^[^,]+,[^,]+,[^,]+$"}


def each_once(text: str, find: Callable[[str], T], noun: str = "model") -> list[T]:
    """Look up comma-separated ids, each of which may be given once.

    Raises
    ------
    UnknownName
        If nothing has an id, naming the nearest.
    NotAllowed
        If an id is given twice.
    """
    ids = [part.strip() for part in text.split(",")]
    found = [find(name) for name in ids]
    repeated = [name for name, count in Counter(ids).items() if count > 1]
    if repeated:
        raise NotAllowed(f"{noun}s", text, f"each {noun} once; {repeated[0]} is there twice")
    return found


def with_model_parameters(base: type[QueryModel], registry: Registry) -> type[QueryModel]:
    """Extend a query by every registered model's parameters, and its `models` by their ids."""
    fields: dict[str, Any] = {
        _field_name(model, parameter): _field(model, parameter)
        for model in registry.values()
        for parameter in model.parameters
    }
    models = base.model_fields.get("models")
    if models is not None and models.description == _ANY_MODELS:
        listed = copy(models)
        listed.description = f"Comma-separated ids of models: {', '.join(registry)}."
        fields["models"] = (str, listed)
    return create_model(f"{base.__name__}WithModels", __base__=base, **fields)


class ModelsQuery(QueryModel):
    """Which models; `with_parameters_of` adds their own parameters."""

    registry: ClassVar[Registry]

    models: ModelsParameter = "exact"

    def chosen(self) -> list[Chosen]:
        """Look up the models, each with what is given for its own parameters.

        Raises
        ------
        UnknownModel, NotAllowed
            As `each_once` does.
        BadParameters
            If parameters of other models are given.
        """
        models = each_once(self.models, self.registry.find)
        refuse_foreign_parameters(self, models, self.registry)
        return [Chosen(model, model_arguments(self, model)) for model in models]


class ModelQuery(QueryModel):
    """Which model; `with_parameters_of` adds the parameters of all."""

    registry: ClassVar[Registry]

    model: ModelId = "exact"

    def chosen(self) -> Chosen:
        """Look up the model, with what is given for its own parameters.

        Raises
        ------
        UnknownModel
            If it is not registered.
        BadParameters
            If parameters of other models are given.
        """
        model = self.registry.find(self.model, "model")
        refuse_foreign_parameters(self, [model], self.registry)
        return Chosen(model, model_arguments(self, model))


def with_parameters_of(registry: Registry) -> Callable[[Endpoint], Endpoint]:
    """Decorate an endpoint: its query takes the parameters of every registered model as well."""

    def extended(endpoint: Endpoint) -> Endpoint:
        signature = inspect.signature(endpoint, eval_str=True)
        parameters = []
        for parameter in signature.parameters.values():
            base, *more = get_args(parameter.annotation) or (parameter.annotation,)
            if isinstance(base, type) and issubclass(base, QueryModel):
                query = with_model_parameters(base, registry)
                query.registry = registry  # type: ignore[attr-defined]
                parameter = parameter.replace(annotation=Annotated[query, *more])
            parameters.append(parameter)
        endpoint.__signature__ = signature.replace(parameters=parameters)  # type: ignore[attr-defined]
        return endpoint

    return extended


def model_arguments(query: QueryModel, model: Model) -> dict[str, ArrayLike | None]:
    """Values of a model's own parameters in the query; a triple has the shape (3, 1)."""
    values = {p.name: getattr(query, _field_name(model, p)) for p in model.parameters}
    return {
        name: np.array(value)[:, np.newaxis] if isinstance(value, tuple) else value
        for name, value in values.items()
    }


def refuse_foreign_parameters(
    query: QueryModel, models: Sequence[Model], registry: Registry
) -> None:
    """Refuse parameters of models that were not asked for, which would otherwise be lost.

    Raises
    ------
    BadParameters
        If there is one.
    """
    own = {_field_name(model, p) for model in models for p in model.parameters}
    foreign = {name for name in query.model_fields_set if "__" in name} - own
    if not foreign:
        return
    errors: list[ParameterError] = [
        {
            "parameter": f"{model.id}.{p.name}",
            "value": getattr(query, _field_name(model, p)),
            "message": f"given although {model.id} is not among the models asked for",
        }
        for model in registry.values()
        for p in model.parameters
        if _field_name(model, p) in foreign
    ]
    raise BadParameters(*errors)


def _field_name(model: Model, parameter: Parameter) -> str:
    return f"{model.id}__{parameter.name}"


def _field(model: Model, parameter: Parameter) -> tuple[Any, Any]:
    """Type and pydantic field of one parameter."""
    alias = f"{model.id}.{parameter.name}"
    if parameter.choices:
        names = tuple(name for name, _ in parameter.choices)
        default = next(n for n, value in parameter.choices if value == parameter.default)
        return Literal[names], Field(default, alias=alias, description=parameter.description)
    if parameter.triple:
        # The core checks the bounds, which pydantic cannot put on one number or three.
        one = {"type": "number", "minimum": parameter.minimum, "maximum": parameter.maximum}
        schema = {
            "anyOf": [one, _THREE],
            "examples": ["0.04", "1.0,0.766,0.336"],
            "unit": parameter.unit,
            "symbol": parameter.symbol,
        }
        kind: Any = Annotated[Any, BeforeValidator(one_or_three), WithJsonSchema(schema)]
        return kind, Field(
            parameter.default,
            alias=alias,
            description=f"{parameter.description} One number, or three for R, G and B.",
        )
    # A default of None is not validated, so that the bounds hold for what is given.
    return Count if parameter.integer else Number, number(parameter, alias=alias)


def one_or_three(text: object) -> object:
    """Read one number, or three separated by commas."""
    try:
        numbers = [_NUMBER.validate_python(part) for part in str(text).split(",")]
    except ValidationError:
        numbers = []
    if len(numbers) not in (1, 3):
        raise PydanticCustomError("triple", "one number, or three separated by commas")
    return tuple(numbers) if len(numbers) == 3 else numbers[0]
