"""Certificates from the witnesses of findings, for an independent checker: what every kind's claims have in common.

FORMAT.md specifies the document, RADIUS.md the claims on joint spectral radii; each kind's folder the rules of its own.
Nothing is computed here that a stage has not found: witnesses are spelled as claims, which say what each costs.
"""

from subdiv_cli.certificate.claims import Certificate, Proofs, document_text
from subdiv_cli.certificate.radius import family_certificate

__all__ = ["Certificate", "Proofs", "document_text", "family_certificate"]
