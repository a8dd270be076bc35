"""Sources of scenes: worlds that are queried box by box."""
