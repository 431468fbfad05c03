package dev.eventchain.simulation;

import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.sandbox.WorkFolder;

/** A confined Python process with the lock-step host of the ROS 2 runtime in it. */
final class LockstepProcess implements NodeHosts {

  private static final String HOST = "eventchain_ros2.lockstep";

  private final WorkFolder workFolder = WorkFolder.create();
  private final ConfinedProcess process;
  private final Watchdog watchdog;
  private final LockstepSession session;

  /**
   * Starts the process.
   *
   * @param turn which of the processes that simulate at the same time it is
   */
  LockstepProcess(
      SimulationRequest request, PythonEnvironment python, Confinement confinement, int turn) {
    this.process =
        new HostProgram(request, python, confinement).process(HOST, turn, workFolder).start();
    this.watchdog = watchdog(request, process);
    this.session =
        new LockstepSession(
            new HostChannel(process.stdout(), process.stdin()),
            watchdog,
            new HostFailures(
                "The process that runs the nodes",
                () -> HostFailures.LastWords.of(process),
                new UserFiles(request.packageFolder())));
  }

  /**
   * The host itself ends components and interrupts nodes that take too long, and says where they
   * were; this is for what it cannot interrupt, when each of them might have used up its time.
   */
  private static Watchdog watchdog(SimulationRequest request, ConfinedProcess process) {
    int all = request.chain().getSoftware().size() + 1;
    SimulationRequest.Limits limits = request.limits();
    return new Watchdog(
        limits.processorTime().multipliedBy(all).plusSeconds(2),
        limits.wallTime().multipliedBy(all).plusSeconds(10),
        process::processorTime,
        process::close);
  }

  @Override
  public NodeSession session() {
    return session;
  }

  @Override
  public void close() {
    watchdog.close();
    process.close();
    workFolder.close();
  }
}
