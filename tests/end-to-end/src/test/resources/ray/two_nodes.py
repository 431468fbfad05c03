"""A Ray cluster of two nodes on this machine: prints its address, and kills one of them at the next line of input."""

import os
import sys
import tempfile

# The paths of Ray's sockets, in this folder, may have 107 characters.
with tempfile.TemporaryDirectory(prefix="two-nodes-", dir="/tmp") as folder:
    os.environ["RAY_TMPDIR"] = folder
    # Else tasks give way to all else on this machine, and hardly go on beside other tests.
    os.environ.update(RAY_worker_niceness="0")
    from ray.cluster_utils import Cluster

    common = {"num_cpus": 1, "object_store_memory": 256 << 20}
    cluster = Cluster(initialize_head=True, head_node_args={**common, "include_dashboard": False})
    second = cluster.add_node(**common)
    cluster.wait_for_nodes()
    print(cluster.address, flush=True)
    if sys.stdin.readline():
        cluster.remove_node(second, allow_graceful=False)
        print("killed", flush=True)
        sys.stdin.readline()
    cluster.shutdown()
