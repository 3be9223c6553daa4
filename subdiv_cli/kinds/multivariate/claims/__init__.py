"""The claims on masks in several variables, as FORMAT.md in this kind's folder says."""

from subdiv_cli.kinds.multivariate.claims.proof import certificate as certificate
