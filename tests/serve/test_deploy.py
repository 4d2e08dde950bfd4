"""What lies in `deploy/` is valid, hardened, and says of the server what is so."""

import ipaddress
import re
from typing import Any

import kubernetes_validate
import pytest
import yaml

from app import __version__
from app.main import create_app
from app.settings import Settings
from tests.serve.command import ROOT

DEPLOY = ROOT / "deploy"
NGINX = (DEPLOY / "nginx" / "nginx.conf").read_text("utf-8")
COMPOSE = yaml.safe_load((DEPLOY / "compose.yaml").read_text("utf-8"))
KUSTOMIZATION = yaml.safe_load((DEPLOY / "kustomization.yaml").read_text("utf-8"))
OBJECTS: list[dict[str, Any]] = [
    document
    for resource in KUSTOMIZATION["resources"]
    for document in yaml.safe_load_all((DEPLOY / resource).read_text("utf-8"))
]
DEPLOYMENTS = {o["metadata"]["name"]: o for o in OBJECTS if o["kind"] == "Deployment"}
SERVICES = {o["metadata"]["name"]: o["spec"] for o in OBJECTS if o["kind"] == "Service"}
CONTAINERS = {
    name: deployment["spec"]["template"]["spec"]["containers"][0]
    for name, deployment in DEPLOYMENTS.items()
}
SERVER = CONTAINERS["fresnel-explorer"]
KUBERNETES = "1.32"
DOCKERFILE = (ROOT / "Dockerfile").read_text("utf-8")


def named(o: dict[str, Any]) -> str:
    return f"{o['kind']}/{o['metadata']['name']}"


def settings_of(variables: dict[str, str]) -> Settings:
    """Read settings as the container would; a misspelled variable is an error here."""
    assert all(name.startswith("FRESNEL_") for name in variables)
    given = {name.removeprefix("FRESNEL_").lower(): value for name, value in variables.items()}
    assert given.keys() <= Settings.model_fields.keys()
    return Settings.model_validate(given)


def kubernetes_settings() -> Settings:
    return settings_of({variable["name"]: variable["value"] for variable in SERVER["env"]})


@pytest.mark.parametrize("manifest", OBJECTS, ids=named)
def test_kubernetes_would_take_it(manifest: dict[str, Any]) -> None:
    kubernetes_validate.validate(manifest, KUBERNETES, strict=True)


def test_the_validator_would_notice() -> None:
    wrong = {**OBJECTS[0], "metadata": {"name": "x", "lables": {}}}
    with pytest.raises(kubernetes_validate.ValidationError):
        kubernetes_validate.validate(wrong, KUBERNETES, strict=True)


def test_everything_that_is_named_exists() -> None:
    on_disk = {str(path.relative_to(DEPLOY)) for path in DEPLOY.glob("kubernetes/*.yaml")}
    assert set(KUSTOMIZATION["resources"]) == on_disk
    (generated,) = KUSTOMIZATION["configMapGenerator"]
    files = [DEPLOY / entry.partition("=")[2] for entry in generated["files"]]
    mounts = [v.split(":")[0] for v in COMPOSE["services"]["nginx"]["volumes"]]
    assert all(path.is_file() for path in [*files, *(DEPLOY / mount for mount in mounts)])
    assert (DEPLOY / COMPOSE["services"]["app"]["build"] / "Dockerfile").is_file()


def test_the_image_is_of_this_version() -> None:
    assert COMPOSE["services"]["app"]["image"] == f"fresnel-explorer:{__version__}"
    assert [image["newTag"] for image in KUSTOMIZATION["images"]] == [__version__]


@pytest.mark.parametrize("name", DEPLOYMENTS)
def test_pods_may_do_nothing_that_they_need_not(name: str) -> None:
    pod = DEPLOYMENTS[name]["spec"]["template"]["spec"]
    assert pod["securityContext"]["runAsNonRoot"] is True
    assert pod["securityContext"]["runAsUser"] > 0
    assert pod["automountServiceAccountToken"] is False
    (container,) = pod["containers"]
    assert container["securityContext"] == {
        "allowPrivilegeEscalation": False,
        "readOnlyRootFilesystem": True,
        "capabilities": {"drop": ["ALL"]},
    }
    assert set(container["resources"]["limits"]) == {"cpu", "memory"}


@pytest.mark.parametrize("name", COMPOSE["services"])
def test_so_with_compose(name: str) -> None:
    service = COMPOSE["services"][name]
    assert service["read_only"] is True
    assert service["cap_drop"] == ["ALL"]
    assert service["security_opt"] == ["no-new-privileges:true"]
    user = service.get("user") or re.findall(r"^USER (.+)$", DOCKERFILE, re.MULTILINE)[-1]
    assert user.split(":")[0].isdigit()
    assert user.split(":")[0] != "0"


def test_probes_ask_routes_that_exist_at_ports_that_are_open() -> None:
    paths = create_app().openapi()["paths"]
    for container in CONTAINERS.values():
        ports = {port["name"] for port in container["ports"]}
        for probe in ("startupProbe", "livenessProbe", "readinessProbe"):
            asked = container.get(probe, {}).get("httpGet")
            if asked:
                assert asked["path"] in paths
                assert asked["port"] in ports
    assert SERVER["livenessProbe"]["httpGet"]["path"] == "/api/v1/health/live"
    assert SERVER["readinessProbe"]["httpGet"]["path"] == "/api/v1/health/ready"
    annotations = DEPLOYMENTS["fresnel-explorer"]["spec"]["template"]["metadata"]["annotations"]
    assert annotations["prometheus.io/path"] in paths


def test_ports_are_those_that_are_listened_at() -> None:
    (inside,) = re.findall(r"^EXPOSE (\d+)$", DOCKERFILE, re.MULTILINE)
    assert SERVER["ports"][0]["containerPort"] == int(inside)
    assert SERVICES["fresnel-explorer-servers"]["clusterIP"] == "None"
    assert COMPOSE["services"]["app"]["expose"] == [inside]
    (listened,) = re.findall(r"listen (\d+)", NGINX)
    assert CONTAINERS["nginx"]["ports"][0]["containerPort"] == int(listened)
    assert COMPOSE["services"]["nginx"]["ports"] == [f"{listened}:{listened}"]
    namespace = KUSTOMIZATION["namespace"]
    for file, host in (
        ("compose", "app"),
        ("kubernetes", f"fresnel-explorer-servers.{namespace}.svc.cluster.local"),
    ):
        upstream = (DEPLOY / "nginx" / f"upstream.{file}.conf").read_text("utf-8")
        assert f"server {host}:{inside} resolve" in upstream
        assert "upstream servers {" in upstream


def test_a_server_has_the_time_to_stop_that_it_takes() -> None:
    settings = kubernetes_settings()
    pod = DEPLOYMENTS["fresnel-explorer"]["spec"]["template"]["spec"]
    probe = SERVER["readinessProbe"]
    noticed = probe["periodSeconds"] * probe["failureThreshold"]
    assert settings.drain_s > noticed
    assert pod["terminationGracePeriodSeconds"] > settings.drain_s + settings.grace_s
    service = COMPOSE["services"]["app"]
    settings = settings_of(service["environment"])
    assert int(service["stop_grace_period"].removesuffix("s")) > settings.drain_s + settings.grace_s
    assert settings.access_log


def test_nginx_waits_and_takes_as_much_as_a_server() -> None:
    (seconds,) = re.findall(r"proxy_read_timeout (\d+)s;", NGINX)
    assert int(seconds) > Settings.model_fields["timeout_s"].default
    (megabytes,) = re.findall(r"client_max_body_size (\d+)m;", NGINX)
    assert int(megabytes) * 2**20 >= Settings.model_fields["max_body_bytes"].default
    # Long heads are read to their end by nginx, and refused by the servers' own bounds.
    for settings in (kubernetes_settings(), settings_of(COMPOSE["services"]["app"]["environment"])):
        assert settings.http == "httptools"


def test_the_servers_believe_nginx_and_only_what_is_inside() -> None:
    compose = settings_of(COMPOSE["services"]["app"]["environment"]).trusted_proxies
    (network,) = COMPOSE["networks"]["default"]["ipam"]["config"]
    assert compose == network["subnet"]
    for trusted in (compose, kubernetes_settings().trusted_proxies):
        for part in trusted.split(","):
            assert not ipaddress.ip_network(part).is_global
    assert "proxy_set_header X-Forwarded-For $remote_addr;" in NGINX  # not what the client says
    assert "ports" not in COMPOSE["services"]["app"]


def test_the_autoscaler_scales_the_servers() -> None:
    (scaler,) = (o["spec"] for o in OBJECTS if o["kind"] == "HorizontalPodAutoscaler")
    assert scaler["scaleTargetRef"]["name"] in DEPLOYMENTS
    assert "replicas" not in DEPLOYMENTS[scaler["scaleTargetRef"]["name"]]["spec"]
    assert scaler["minReplicas"] >= 2
    assert "cpu" in SERVER["resources"]["requests"]
    for service in SERVICES.values():
        chosen = [
            d
            for d in DEPLOYMENTS.values()
            if service["selector"].items() <= d["spec"]["template"]["metadata"]["labels"].items()
        ]
        assert len(chosen) == 1
