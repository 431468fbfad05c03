package dev.eventchain.m2t;

import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import java.util.Collection;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.eclipse.emf.ecore.EObject;

/** Generates on a small stack, which endless recursion fills in less time. */
final class ShallowStack {
  private static final long SIZE = 16L << 20;

  private ShallowStack() {}

  static GenerationResult generate(
      TemplateModule module, Collection<? extends EObject> roots, GenerationContext context) {
    FutureTask<GenerationResult> task = new FutureTask<>(() -> module.generateHere(roots, context));
    new Thread(null, task, "shallow", SIZE).start();
    try {
      return task.get();
    } catch (ExecutionException e) {
      throw new AssertionError(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }
}
