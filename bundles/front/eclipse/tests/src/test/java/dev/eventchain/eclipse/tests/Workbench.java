package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.Platform;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchPage;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.editors.text.TextEditor;
import org.eclipse.ui.ide.IDE;

/**
 * The workbench for tests that run on another thread. Without a display there is none, and tests
 * that need it are skipped.
 */
final class Workbench {

  /** Time limit that only ends hanging tests: no test depends on the speed of the machine. */
  private static final Duration FOREVER = Duration.ofMinutes(3);

  private Workbench() {}

  /** Skips the test unless there is a workbench, and closes the welcome page. */
  static void require() {
    assumeTrue(
        Platform.getBundle("org.eclipse.ui") != null && PlatformUI.isWorkbenchRunning(),
        "there is no display");
    run(
        () -> {
          IWorkbenchPage page = page();
          page.closeAllEditors(false);
          return page;
        });
  }

  /** Runs work on the user interface's thread and returns its result. */
  static <T> T run(Callable<T> work) {
    AtomicReference<T> result = new AtomicReference<>();
    AtomicReference<Throwable> failure = new AtomicReference<>();
    display()
        .syncExec(
            () -> {
              try {
                result.set(work.call());
              } catch (Throwable e) { // passed to the test's own thread
                failure.set(e);
              }
            });
    if (failure.get() != null) {
      throw new AssertionError(failure.get());
    }
    return result.get();
  }

  /** Waits until a condition holds, checked on the user interface's thread. */
  static void waitUntil(String what, Callable<Boolean> condition) {
    waitFor(() -> run(condition), () -> what);
  }

  /** Waits until a condition holds, checked on this thread. */
  static void waitFor(BooleanSupplier condition, Supplier<String> what) {
    long end = System.nanoTime() + FOREVER.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        fail("this never happened: " + what.get());
      }
      try {
        Thread.sleep(20);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        fail("interrupted while waiting for: " + what.get());
      }
    }
  }

  /** Returns the page of the first window; in the user interface's thread only. */
  /** Opens a file in the editor for texts that it has. */
  static TextEditor open(IFile file) {
    return run(() -> (TextEditor) IDE.openEditor(page(), file));
  }

  /** Closes all editors without saving, and removes a project, if there is one. */
  static void close(TestProject project) throws Exception {
    if (project != null) {
      run(() -> page().closeAllEditors(false));
      project.close();
    }
  }

  static IWorkbenchPage page() {
    return PlatformUI.getWorkbench().getWorkbenchWindows()[0].getActivePage();
  }

  static Display display() {
    return PlatformUI.getWorkbench().getDisplay();
  }

  /** Draws the window into {@code target/screenshots/NAME.png}, for people to look at. */
  static void screenshot(String name) {
    run(
        () -> {
          Shell[] shells = display().getShells();
          Shell shell = display().getActiveShell() != null ? display().getActiveShell() : shells[0];
          Rectangle bounds = shell.getBounds();
          Image image = new Image(display(), bounds.width, bounds.height);
          GC gc = new GC(display());
          gc.copyArea(image, bounds.x, bounds.y);
          gc.dispose();
          ImageLoader loader = new ImageLoader();
          loader.data = new ImageData[] {image.getImageData()};
          image.dispose();
          Path folder = Path.of(System.getProperty("eventchain.screenshots", "target/screenshots"));
          Files.createDirectories(folder);
          loader.save(folder.resolve(name + ".png").toString(), SWT.IMAGE_PNG);
          return folder;
        });
  }
}
