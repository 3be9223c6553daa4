"""Findings' witnesses -> a certificate that an independent checker accepts. FORMAT.md in this folder specifies it.

Nothing is computed here that a stage has not found: the writer spells witnesses as claims, and says what each costs.
"""

from subdiv_cli.certificate.claims import document_text
from subdiv_cli.kinds.scalar.claims.writer import Certificate, certificate, family_certificate

__all__ = ["Certificate", "certificate", "document_text", "family_certificate"]
