"""The run as it passed: picks, what agents did, what was counted; a click goes back there."""
