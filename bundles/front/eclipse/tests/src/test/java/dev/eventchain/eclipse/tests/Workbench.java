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

/**
 * The workbench as tests use it, from a thread that is not its own. Without a display there is
 * none, and a test that needs it is skipped.
 */
final class Workbench {

  /** Only ends what would never end: no test depends on how fast the machine is. */
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

  /** Does something in the user interface's thread and returns what came of it. */
  static <T> T run(Callable<T> work) {
    AtomicReference<T> result = new AtomicReference<>();
    AtomicReference<Throwable> failure = new AtomicReference<>();
    display()
        .syncExec(
            () -> {
              try {
                result.set(work.call());
              } catch (Throwable e) { // handed to the test's own thread
                failure.set(e);
              }
            });
    if (failure.get() != null) {
      throw new AssertionError(failure.get());
    }
    return result.get();
  }

  /** Waits until something holds, asking in the user interface's thread. */
  static void waitUntil(String what, Callable<Boolean> condition) {
    waitFor(() -> run(condition), () -> what);
  }

  /** Waits until something holds, asking in this thread. */
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

  /** The page of the first window; in the user interface's thread only. */
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
