"""Jobs in workers: the only place that starts any, whatever kind of workers they are."""
