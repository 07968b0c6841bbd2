"""Server-manager XML for ParaView, generated from what BRDFLab's classes say."""
