"""The files of deploy/compose and deploy/kubernetes agree with each other and with the
programs they name. No engine or cluster is needed, and none is tried.

    deploy_test.py --server GEODESICD

Wants python3-yaml; haproxy, promtool and kubectl are asked where they are there.
"""

import argparse
import collections
import fnmatch
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import yaml
except ImportError:
    print("python3-yaml is not installed: skipped")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEPLOY = ROOT / "deploy"
ARGUMENTS = None
UNITS = {"B": 1, "KiB": 2**10, "MiB": 2**20, "GiB": 2**30}


def size(text):
    """Of 512MiB or, as Kubernetes writes it, 14Gi."""
    number, unit = re.fullmatch(r"(\d+)([KMG]i)B?", text).groups()
    return int(number) * UNITS[unit + "B"]


def settings_of_server():
    """The server's flags and, by their names, the defaults of its variables."""
    text = subprocess.run([ARGUMENTS.server, "--help"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    flags = set(re.findall(r"^  (--[a-z-]+)", text, re.M))
    variables = dict(
        (name, default) for default, name in re.findall(
            # "=4GiB", or "[4GiB]" from CLI11 2.4 on.
            r"^  --[a-z-]+(?: NAME=VALUE)?[^=[\n(]*(?:[=[]([^]\s]+)\]?)? +\(Env:(\w+)\)", text,
            re.M))
    return flags, variables


def program(name):
    return shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")


class DeployTest(unittest.TestCase):

    def check_settings(self, arguments, environment):
        flags, variables = settings_of_server()
        self.assertIn("GEODESICD_MEMORY", variables)
        for argument in arguments:
            self.assertIn(argument.partition("=")[0], flags)
        for name in environment:
            self.assertIn(name, variables)

    def check_haproxy(self, path):
        """HAProxy reads it, and it chooses servers as deploy/cluster does."""
        shipped = (DEPLOY / "cluster" / "haproxy.cfg").read_text()
        choice = r"^ +(?:balance|hash-type|hash-balance).*$"
        weight = r"default-server weight \d+"
        text = path.read_text()
        for pattern in (choice, weight):
            self.assertTrue(re.findall(pattern, shipped, re.M))
            self.assertEqual(re.findall(pattern, text, re.M),
                             re.findall(pattern, shipped, re.M))
        if program("haproxy"):
            subprocess.run([program("haproxy"), "-c", "-q", "-f", path],
                           check=True)
        return re.findall(r"^  server (\S+) (\S+)", text, re.M)

    def check_head(self, path):
        """It says that it was not tried."""
        head = path.read_text().splitlines()[:8]
        self.assertTrue(any("ot tried" in line for line in head), path)


class ImageTest(DeployTest):

    def test_settings_and_ports(self):
        compose = yaml.safe_load((ROOT / "docker" / "compose.yaml").read_text())
        service = compose["services"]["geodesicd"]
        self.check_settings([], service["environment"])
        image = (ROOT / "docker" / "Dockerfile").read_text()
        exposed = re.search(r"(?m)^EXPOSE (.*)$", image)[1].split()
        self.assertEqual(exposed, [port.rpartition(":")[2]
                                   for port in service["ports"]])
        self.check_settings([], re.findall(r"(GEODESICD_\w+)=", image))
        for port in service["ports"]:
            self.assertTrue(port.startswith("127.0.0.1:"), port)
        volume, folder = service["volumes"][0].split(":")
        self.assertIn(volume, compose["volumes"])
        self.assertRegex(image, rf"(?m)^VOLUME {folder}$")

    def test_the_builder_gets_every_file(self):
        patterns = [line for line in
                    (ROOT / ".dockerignore").read_text().splitlines()
                    if line and not line.startswith("#")]
        files = shutil.which("git") and subprocess.run(
            ["git", "ls-files"], cwd=ROOT, text=True, stdout=subprocess.PIPE,
            check=False).stdout.split()
        if not files:
            self.skipTest("no repository of git")
        for file in map(pathlib.PurePath, files):
            for part in [file, *file.parents][:-1]:
                for pattern in patterns:
                    self.assertFalse(fnmatch.fnmatch(
                        part.name if pattern.startswith("**/") else str(part),
                        pattern.removeprefix("**/")), f"{file}: {pattern}")


class ComposeTest(DeployTest):

    def setUp(self):
        self.folder = DEPLOY / "compose"
        self.compose = yaml.safe_load((self.folder / "compose.yaml").read_text())

    def test_heads(self):
        for path in self.folder.iterdir():
            self.check_head(path)

    def test_replicas(self):
        replicas = {name: service
                    for name, service in self.compose["services"].items()
                    if service["image"] == "geodesic"}
        self.assertEqual(len(replicas), 3)
        addresses = {name + ":50051" for name in replicas}
        for service in replicas.values():
            flags = collections.defaultdict(set)
            for name, _, value in (f.partition("=") for f in service["command"]):
                flags[name].add(value)
            tier, port = flags.pop("--shared-tier").pop().split(":")
            self.assertEqual((port, dict(flags)), ("6379", {}))
            self.assertIn("redis", self.compose["services"][tier]["image"])
            self.check_settings(service["command"], service["environment"])
            build = service["build"]
            dockerfile = (self.folder / build["context"] / build["dockerfile"])
            self.assertTrue(dockerfile.is_file())
            drain = int(service["environment"]["GEODESICD_DRAIN_SECONDS"])
            self.assertLess(drain, int(service["stop_grace_period"][:-1]))
        servers = self.check_haproxy(self.folder / "haproxy.cfg")
        self.assertEqual({address for _, address in servers}, addresses)
        prometheus = yaml.safe_load(
            (self.folder / "prometheus.yaml").read_text())
        metrics = next(iter(replicas.values()))["environment"][
            "GEODESICD_METRICS_LISTEN"].rpartition(":")[2]
        self.assertEqual(
            set(prometheus["scrape_configs"][0]["static_configs"][0]["targets"]),
            {f"{name}:{metrics}" for name in replicas})

    def test_mounted_files_are_there(self):
        mounted = {}
        for service in self.compose["services"].values():
            for volume in service.get("volumes", []):
                source, target, mode = volume.split(":")
                self.assertTrue((self.folder / source).is_file(), source)
                self.assertEqual(mode, "ro")
                mounted[target] = self.folder / source
                self.assertIn(os.path.dirname(target),
                              " ".join(service["command"]))
        if program("promtool"):
            # As it lies in the container.
            with tempfile.TemporaryDirectory() as folder:
                for target, source in mounted.items():
                    if target.startswith("/etc/prometheus"):
                        shutil.copy(source, folder)
                subprocess.run([program("promtool"), "check", "config",
                                os.path.join(folder, "prometheus.yaml")],
                               check=True, stdout=subprocess.DEVNULL)

    def test_only_this_machine_reaches_it(self):
        for service in self.compose["services"].values():
            for port in service.get("ports", []):
                self.assertTrue(port.startswith("127.0.0.1:"), port)


class KubernetesTest(DeployTest):

    def setUp(self):
        self.folder = DEPLOY / "kubernetes"
        self.kustomization = yaml.safe_load(
            (self.folder / "kustomization.yaml").read_text())
        self.objects = {}
        for name in self.kustomization["resources"]:
            for part in yaml.safe_load_all((self.folder / name).read_text()):
                self.objects[part["kind"], part["metadata"]["name"]] = part

    def pods(self, kind, name):
        return self.objects[kind, name]["spec"]["template"]

    def test_heads_and_that_all_files_are_used(self):
        files = {path.name for path in self.folder.iterdir()}
        self.assertEqual(
            files, set(self.kustomization["resources"]) |
            set(self.kustomization["configMapGenerator"][0]["files"]) |
            {"kustomization.yaml"})
        for path in self.folder.iterdir():
            self.check_head(path)

    def test_kustomize_and_kubectl(self):
        if not program("kubectl"):
            self.skipTest("no kubectl")
        built = subprocess.run(
            [program("kubectl"), "kustomize", self.folder], check=True,
            stdout=subprocess.PIPE).stdout
        objects = list(yaml.safe_load_all(built))
        self.assertEqual(len(objects), len(self.objects) + 1)
        for part in objects:
            if part["kind"] != "Namespace":
                self.assertEqual(part["metadata"]["namespace"], "geodesic")
        # What kubectl itself reads as a StatefulSet or Deployment and writes again:
        # a name it does not know would be gone, a wrong type refused.
        for part in objects:
            if part["kind"] not in ("StatefulSet", "Deployment"):
                continue
            again = yaml.safe_load(subprocess.run(
                [program("kubectl"), "set", "env", "--local", "-f", "-", "X=y",
                 "-o", "yaml"], check=True, input=yaml.safe_dump(part).encode(),
                stdout=subprocess.PIPE).stdout)
            self.check_kept(part, again, part["kind"])

    def check_kept(self, part, whole, where):
        if isinstance(part, dict):
            for key, value in part.items():
                self.assertIn(key, whole, where)
                self.check_kept(value, whole[key], f"{where}.{key}")
        elif isinstance(part, list):
            for number, value in enumerate(part):
                self.check_kept(value, whole[number], f"{where}[{number}]")
        else:
            self.assertEqual(part, whole, where)

    def test_selectors_find_pods_and_ports_have_names(self):
        pods = [template for (kind, _), part in self.objects.items()
                if kind in ("StatefulSet", "Deployment")
                for template in [part["spec"]["template"]]]
        self.assertEqual(len(pods), 3)

        def ports_of(labels):
            found = [pod for pod in pods
                     if labels.items() <= pod["metadata"]["labels"].items()]
            self.assertEqual(len(found), 1, labels)
            return {port["name"]
                    for port in found[0]["spec"]["containers"][0]["ports"]}

        for (kind, name), part in self.objects.items():
            with self.subTest(kind=kind, name=name):
                spec = part.get("spec", {})
                if kind == "Service":
                    names = ports_of(spec["selector"])
                    self.assertLessEqual(
                        {port["targetPort"] for port in spec["ports"]}, names)
                elif kind in ("PodDisruptionBudget", "StatefulSet", "Deployment"):
                    ports_of(spec["selector"]["matchLabels"])
                elif kind == "NetworkPolicy":
                    own = ports_of(spec["podSelector"]["matchLabels"])
                    for rule in spec["ingress"]:
                        self.assertLessEqual(
                            {port["port"] for port in rule["ports"]}, own)
                    for rule in spec["egress"]:
                        for peer in rule.get("to", []):
                            self.assertLessEqual(
                                {port["port"] for port in rule["ports"]},
                                ports_of(peer["podSelector"]["matchLabels"]))

    def test_replicas(self):
        spec = self.pods("StatefulSet", "geodesicd")["spec"]
        container = spec["containers"][0]
        environment = {item["name"]: item["value"] for item in container["env"]}
        self.check_settings([], environment)
        self.assertLess(int(environment["GEODESICD_DRAIN_SECONDS"]),
                        spec["terminationGracePeriodSeconds"])
        self.assertEqual(container["resources"]["requests"]["cpu"],
                         environment["GEODESICD_THREADS"])
        image = (ROOT / "docker" / "Dockerfile").read_text()
        user = spec["securityContext"]
        self.assertRegex(image, rf"(?m)^USER {user['runAsUser']}:{user['runAsGroup']}$")
        self.assertEqual(user["fsGroup"], user["runAsGroup"])
        folder = container["volumeMounts"][0]["mountPath"]
        self.assertRegex(image, rf"(?m)^VOLUME {folder}$")

        scaler = self.objects["HorizontalPodAutoscaler", "geodesicd"]["spec"]
        self.assertEqual(
            (scaler["scaleTargetRef"]["kind"], scaler["scaleTargetRef"]["name"]),
            ("StatefulSet", "geodesicd"))
        self.assertEqual(
            scaler["minReplicas"],
            self.objects["StatefulSet", "geodesicd"]["spec"]["replicas"])
        service = self.objects["StatefulSet", "geodesicd"]["spec"]["serviceName"]
        self.assertEqual(self.objects["Service", service]["spec"]["clusterIP"],
                         "None")
        names = [f"geodesicd-{n}.{service}" for n in range(scaler["maxReplicas"])]
        tier, port = environment["GEODESICD_SHARED_TIER"].split(":")
        self.assertIn(int(port), [
            told["port"] for told in self.objects["Service", tier]["spec"]["ports"]])
        servers = self.check_haproxy(self.folder / "haproxy.cfg")
        self.assertEqual(
            [address for _, address in servers],
            [name + ".geodesic.svc.cluster.local:50051" for name in names])
        self.assertIn("name: geodesic\n",
                      (self.folder / "namespace.yaml").read_text())

    def test_budgets_fit(self):
        container = self.pods("StatefulSet", "geodesicd")["spec"]["containers"][0]
        environment = {item["name"]: item["value"] for item in container["env"]}
        disk = self.objects["StatefulSet", "geodesicd"]["spec"][
            "volumeClaimTemplates"][0]["spec"]["resources"]["requests"]["storage"]
        self.assertLess(size(environment["GEODESICD_DISK"]), size(disk))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
