"""Jobs in processes of their own: the only place that starts any."""
