"""How fast the rollouts are, beside what others would write."""
