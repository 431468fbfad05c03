package dev.eventchain.pipeline.start;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.workspace.FoundSoftware;
import dev.eventchain.workspace.Nodl;
import dev.eventchain.workspace.RecordedSignals;
import dev.eventchain.workspace.Recording;
import dev.eventchain.workspace.SoftwareBaseFiles;
import dev.eventchain.workspace.Workspace;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** Creates a project around software of ROS 2 that exists. */
public final class WorkspaceStart {

  private WorkspaceStart() {}

  /**
   * Writes a project into a new or empty folder.
   *
   * @param workspace its sources are read, and nothing of them is run
   * @param launch the launch file that starts the software; by default the only one that no other
   *     one includes
   * @param progress receives what is done, if a Python environment has to be made
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link Workspace#read} and {@link
   *     ProjectStart#create}
   */
  public static ProjectStart.Started create(
      Path folder,
      Path workspace,
      Optional<Path> launch,
      ProjectStart.BenchProposal bench,
      Consumer<String> progress) {
    FoundSoftware software = Workspace.read(workspace, launch, PythonEnvironment.ensure(progress));
    MessageCatalog messages = MessageCatalog.of(List.of(workspace));
    return ProjectStart.around(SoftwareBaseFiles.of(software, messages), folder, bench, Map.of());
  }

  /**
   * Writes a project into a new or empty folder, around nodes whose interfaces are described in
   * NoDL.
   *
   * @param documents one for each node, whose name is that of the file
   * @param messages folders with definitions of messages that are not standard
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link Nodl#read} and {@link
   *     ProjectStart#create}
   */
  public static ProjectStart.Started ofInterfaces(
      Path folder, List<Path> documents, List<Path> messages, ProjectStart.BenchProposal bench) {
    FoundSoftware software = Nodl.read(documents);
    MessageCatalog catalog = MessageCatalog.of(messages);
    return ProjectStart.around(SoftwareBaseFiles.of(software, catalog), folder, bench, Map.of());
  }

  /**
   * Writes a project into a new or empty folder, around the topics of a recording.
   *
   * @param recording an MCAP file, or a folder that rosbag2 wrote
   * @throws dev.eventchain.diagnostics.DiagnosticException as {@link Recording#read} and {@link
   *     ProjectStart#create}
   */
  public static ProjectStart.Started ofRecording(
      Path folder, Path recording, ProjectStart.BenchProposal bench) {
    Recording read = Recording.read(recording);
    return ProjectStart.around(RecordedSignals.of(read), folder, bench, read.rates());
  }
}
