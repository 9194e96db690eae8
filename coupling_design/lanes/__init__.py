"""How does a CasADi step become machine code? Knows nothing of machines.

>>> march = compile_march(step, 120_000)          # doctest: +SKIP

Read `graph` (a step as operations), `rewriting` (identities that make it cheaper),
`source` (the operations as C), then `kernels`, `store`, `compiler` and `march`.
README.md has an example, the contract and what each rewriting is worth.
"""
