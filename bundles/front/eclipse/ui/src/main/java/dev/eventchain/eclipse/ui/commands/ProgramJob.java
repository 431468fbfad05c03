package dev.eventchain.eclipse.ui.commands;

import dev.eventchain.eclipse.Program;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.core.resources.IContainer;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.OperationCanceledException;
import org.eclipse.core.runtime.Status;
import org.eclipse.core.runtime.jobs.IJobChangeEvent;
import org.eclipse.core.runtime.jobs.Job;
import org.eclipse.core.runtime.jobs.JobChangeAdapter;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchListener;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.console.ConsolePlugin;
import org.eclipse.ui.console.IConsole;
import org.eclipse.ui.console.MessageConsole;
import org.eclipse.ui.console.MessageConsoleStream;

/** A run of {@code eventchain} with its output in a console; cancelling the job ends the run. */
final class ProgramJob extends Job {

  /** Longest time in ms that the workbench waits for a run to complete its files. */
  private static final long LONGEST_END = 12_000;

  private final Program program;
  private final String command;
  private final IContainer folder;

  ProgramJob(Program program, String command, IContainer folder) {
    super("eventchain " + command + " " + folder.getName());
    this.program = program;
    this.command = command;
    this.folder = folder;
    setUser(false); // in the background, with its output in the console
  }

  /** Returns whether a run of a project is in progress. */
  static boolean isRunning(IContainer folder) {
    return Job.getJobManager().find(folder.getFullPath()).length > 0;
  }

  @Override
  public boolean belongsTo(Object family) {
    return folder.getFullPath().equals(family);
  }

  /**
   * Starts the run, and asks before the workbench is closed during it. From the workbench's thread
   * only.
   */
  void start() {
    IWorkbenchListener closing =
        new IWorkbenchListener() {
          @Override
          public boolean preShutdown(IWorkbench workbench, boolean forced) {
            return forced || mayEnd(workbench);
          }

          @Override
          public void postShutdown(IWorkbench workbench) {
            // It has ended by then.
          }
        };
    IWorkbench workbench = PlatformUI.getWorkbench();
    workbench.addWorkbenchListener(closing);
    addJobChangeListener(
        new JobChangeAdapter() {
          @Override
          public void done(IJobChangeEvent event) {
            workbench.removeWorkbenchListener(closing);
          }
        });
    schedule();
  }

  private boolean mayEnd(IWorkbench workbench) {
    boolean ends =
        MessageDialog.openQuestion(
            workbench.getModalDialogShellProvider().getShell(),
            "Eventchain",
            getName() + " is still running. End it?");
    if (ends) {
      cancel();
      try {
        join(LONGEST_END, null);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
    return ends;
  }

  @Override
  protected IStatus run(IProgressMonitor monitor) {
    monitor.beginTask(getName(), IProgressMonitor.UNKNOWN);
    MessageConsole console = console();
    try (MessageConsoleStream output = console.newMessageStream()) {
      output.println("> " + getName());
      int code = start(output, monitor);
      output.println();
      output.println(meaning(code));
      folder.refreshLocal(IResource.DEPTH_INFINITE, monitor);
      return Status.OK_STATUS;
    } catch (OperationCanceledException e) {
      return Status.CANCEL_STATUS;
    } catch (CoreException e) {
      return e.getStatus(); // the platform shows it in a dialog
    } catch (IOException e) {
      return Status.error("The console was closed: " + e.getMessage());
    }
  }

  private int start(MessageConsoleStream output, IProgressMonitor monitor) throws CoreException {
    try {
      Path path = folder.getLocation().toPath();
      return program.run(List.of(command, path.toString()), path, output::print, monitor);
    } catch (OperationCanceledException e) {
      output.println();
      output.println("Cancelled: every file is as it was or complete.");
      folder.refreshLocal(IResource.DEPTH_INFINITE, null);
      throw e;
    }
  }

  /** Returns the meaning of an exit code, as in the program's help. */
  private static String meaning(int code) {
    return switch (code) {
      case 0 -> "Done.";
      case 1 -> "There are findings, or the verdict is not PASSED.";
      case 2 -> "It could not be done; the reason is given above.";
      case 3 -> "This machine lacks something that the command needs; it is named above.";
      case 4 -> "A language model's answer is awaited; the output above says where.";
      default -> "It ended with " + code + ".";
    };
  }

  private MessageConsole console() {
    String name = "Eventchain: " + folder.getFullPath();
    for (IConsole each : ConsolePlugin.getDefault().getConsoleManager().getConsoles()) {
      if (each instanceof MessageConsole known && known.getName().equals(name)) {
        known.clearConsole();
        ConsolePlugin.getDefault().getConsoleManager().showConsoleView(known);
        return known;
      }
    }
    MessageConsole made = new MessageConsole(name, null);
    made.addPatternMatchListener(new PlaceLinks());
    ConsolePlugin.getDefault().getConsoleManager().addConsoles(new IConsole[] {made});
    ConsolePlugin.getDefault().getConsoleManager().showConsoleView(made);
    return made;
  }
}
