package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.io.File;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.eclipse.emf.ecore.EcorePackage;
import org.junit.jupiter.api.RepeatedTest;

/** Several threads of a program may be the first ones to use OCL, as goals of Maven modules are. */
class FirstUseTest {
  private static final int THREADS = 4;

  /** Loaded again for each try, with OCL and all that it keeps for the whole program. */
  public static final class Parse implements Callable<List<String>> {
    private static final CyclicBarrier START = new CyclicBarrier(THREADS);

    @Override
    public List<String> call() throws Exception {
      ExpressionLanguage language = ExpressionLanguage.of(List.of(EcorePackage.eINSTANCE));
      List<String> problems = new ArrayList<>();
      START.await(60, TimeUnit.SECONDS); // not for ever for a thread that has failed
      for (String kind : List.of("Set", "Bag", "OrderedSet", "Sequence")) {
        String text = kind + "{1, 2}->select(x | x > 1)->asSequence()->union(Sequence{3})->size()";
        List<Diagnostic> found = new ArrayList<>();
        if (language
            .parse(SourceText.of("first", text).whole(), language.root(), found)
            .isEmpty()) {
          problems.add(kind + " was not parsed: " + found);
        }
      }
      return problems;
    }
  }

  @RepeatedTest(5)
  void threadsThatBeginAtOnceFindAllOperations() throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(THREADS);
    try (URLClassLoader loader = new URLClassLoader(classPath(), platform())) {
      // Two threads that begin at two classes of Ecore wait for each other: users load it first.
      Class.forName(EcorePackage.class.getName(), true, loader);
      List<Callable<List<String>>> all = new ArrayList<>();
      for (int i = 0; i < THREADS; i++) {
        all.add(parse(loader));
      }
      for (Future<List<String>> each : threads.invokeAll(all)) {
        assertEquals(List.of(), each.get());
      }
    } finally {
      threads.shutdownNow();
    }
  }

  @SuppressWarnings("unchecked")
  private static Callable<List<String>> parse(ClassLoader loader)
      throws ReflectiveOperationException {
    return (Callable<List<String>>)
        loader.loadClass(Parse.class.getName()).getConstructor().newInstance();
  }

  private static ClassLoader platform() {
    return ClassLoader.getPlatformClassLoader();
  }

  private static URL[] classPath() throws MalformedURLException {
    List<URL> urls = new ArrayList<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      urls.add(Path.of(entry).toUri().toURL());
    }
    return urls.toArray(URL[]::new);
  }
}
