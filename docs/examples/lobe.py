import brdflab  # PYTHONPATH=build/release/lib/python3/dist-packages

source = brdflab.vtkBRDFSource()
source.SetMaterial("0.3*Lambertian + 0.04*GGX(alpha=0.2, ior=1.5)")
view = brdflab.vtkBRDFLobeView()
view.AddInputConnection(source.GetOutputPort())
view.WritePNG("lobe.png")
