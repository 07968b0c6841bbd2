#!/usr/bin/env bash
# Builds examples/plugin against the package that check_examples.sh installed, and uses what it registers from the
# command line and from Python, with nothing of BRDFLab built again.
#   check_plugin.sh CMAKE SCRATCH_FOLDER PYTHON_OR_EMPTY PYTHON_FOLDER
set -euo pipefail
cmake=$1 scratch=$2 python=$3 python_folder=$4
prefix=$scratch/prefix
brdf=$prefix/bin/brdf
source=$(find "$prefix" -type d -path '*/examples/plugin')
build=$scratch/plugin-build

fail() {
  echo "$*"
  exit 1
}

rm -rf "$build" "$scratch/plugin-run" "$scratch/plugin-installed"
mkdir -p "$scratch/plugin-run"
cd "$scratch/plugin-run"
"$cmake" -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" >configure.log 2>&1 ||
  { cat configure.log; exit 1; }
"$cmake" --build "$build" >build.log 2>&1 || { cat build.log; exit 1; }

if "$brdf" eval "WorkshopGloss" --at 0,0,0,0 --quiet 2>/dev/null; then fail "the plugin's lobe is there without it"; fi
export BRDFLAB_PLUGIN_PATH=$build
"$brdf" plugins | grep 'workshop *1.0 *loaded' >/dev/null

# The lobe: (n + 2) / (8 pi) at the half vector. The material: a turned one has the value of the other at turned
# directions.
close() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a - b < 1e-12 && b - a < 1e-12) }' || fail "$1 is not $2"; }
value_of() { "$brdf" eval "$1" --at "$2" --json - | tr -d ' \n' | sed 's/.*"value":\[\([^],]*\).*/\1/'; }
close "$(value_of "WorkshopGloss(n=38)" 20,0,20,180)" 1.5915494309189535
close "$(value_of "turned:30,Ward(ax=0.1, ay=0.4)" 40,50,30,200)" "$(value_of "Ward(ax=0.1, ay=0.4)" 40,20,30,170)"

# The format: samples of a Lambertian of albedo 0.5.
{
  echo "workshop goniometer"
  for i in 0 20 40 60; do for o in 0 25 50 75; do for phi in 0 60 120 180; do echo "$i $o $phi 0.15915494309189535"; done; done; done
} >flat.gonio
"$brdf" info flat.gonio | grep goniometer >/dev/null
close "$(value_of flat.gonio 33,0,44,90)" 0.15915494309189535
echo "broken line" >>flat.gonio
cp flat.gonio broken.gonio
sed -i '$d' flat.gonio
if "$brdf" info broken.gonio 2>error.txt; then fail "a broken file was read"; fi
grep -q 'line 66' error.txt

# The surface: light along the normal leaves mirror roofs of slope 15 degrees at 30 degrees across them, and all of it.
"$brdf" simulate "roofs(slope=15)" --theta-i 0 --phi-i 0 --tolerance 0.1 --out roofs.vtkhdf --quiet
close "$(value_of roofs.vtkhdf 0,0,30,90)" 0
awk -v f="$(value_of roofs.vtkhdf 0,0,30,0)" 'BEGIN { exit !(f > 1) }' || fail "mirror roofs send nothing to 30 degrees"
if "$brdf" simulate "roofs(slope=95)" --out no.vtkhdf 2>error.txt; then fail "roofs of 95 degrees were made"; fi
grep -q 'roofs.*out of bounds.*found 95' error.txt

# The metric and the optimizer find the parameter that made the target.
"$brdf" fit "0.2*WorkshopGloss(n=50)" --lobes WorkshopGloss --metric fourth_root --optimizer compass --json fit.json --quiet
tr -d ' \n' <fit.json | grep '"metric":"fourth_root' >/dev/null
n=$(tr -d ' \n' <fit.json | sed 's/.*"name":"n"[^}]*"value":\([0-9.e+-]*\).*/\1/')
awk -v n="$n" 'BEGIN { exit !(n > 49.9 && n < 50.1) }' || fail "the fit found n = $n, not 50"
"$brdf" compare "0.2*WorkshopGloss(n=50)" "0.2*WorkshopGloss(n=60)" --json - | grep fourth_root >/dev/null
"$brdf" lobe "turned:45,Ward(ax=0.1, ay=0.4)" flat.gonio --size 200x200 --out lobe.png --quiet
"$brdf" render "turned:45,Ward(ax=0.1, ay=0.4)" --light directional:30,0 --size 32x32 --out sphere.exr --quiet
"$brdf" check "WorkshopGloss(n=50)" --quiet

# A library of another version, and one that is no plugin, are left out with a warning; the rest works.
mkdir -p wrong
cp "$prefix"/lib*/libbrdf_pictures.so wrong/ 2>/dev/null || cp "$(find "$prefix" -name libbrdf_pictures.so)" wrong/
printf 'nonsense' >wrong/nonsense.so
BRDFLAB_PLUGIN_PATH=$scratch/plugin-run/wrong "$brdf" eval Lambertian --at 0,0,0,0 --quiet 2>warnings.txt
[ "$(grep -c '^brdf: warning: plugin left out' warnings.txt)" -eq 2 ] || { cat warnings.txt; exit 1; }

# Installed beside the library it needs no variable.
unset BRDFLAB_PLUGIN_PATH
cp -r "$prefix" "$scratch/plugin-installed"
"$cmake" --install "$build" --prefix "$scratch/plugin-installed" >/dev/null
"$scratch/plugin-installed/bin/brdf" models WorkshopGloss >/dev/null

if [ -n "$python" ]; then
  BRDFLAB_PLUGIN_PATH=$build PYTHONPATH=$prefix/$python_folder "$python" - <<'PYTHON'
import brdflab
from vtkmodules.vtkCommonCore import vtkStringArray

def names(kind):
    array = vtkStringArray()
    assert brdflab.vtkBRDFRegistry.GetNames(kind, array)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]

for kind, name in (("lobes", "WorkshopGloss"), ("formats", "goniometer"), ("metrics", "fourth_root"),
                   ("optimizers", "compass"), ("materials", "turned"), ("surfaces", "roofs")):
    assert name in names(kind), (kind, names(kind))
assert names("failures") == [], names("failures")
source = brdflab.vtkBRDFSource()
source.SetMaterial("flat.gonio")
fit = brdflab.vtkBRDFFit()
fit.SetInputConnection(source.GetOutputPort())
fit.SetLobes("Lambertian")
fit.SetMetric("fourth_root")
assert fit.UpdateAndCheck(), fit.GetPipelineErrorText()
assert abs(fit.GetParameters().GetValueByName(0, "value").ToDouble() - 0.5) < 1e-6
PYTHON
fi
