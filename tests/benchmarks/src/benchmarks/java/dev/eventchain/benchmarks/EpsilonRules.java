package dev.eventchain.benchmarks;

import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.epsilon.emc.emf.InMemoryEmfModel;
import org.eclipse.epsilon.evl.EvlModule;
import org.eclipse.epsilon.evl.concurrent.EvlModuleParallelElements;

/** The paper's constraints in Epsilon EVL, parsed once, on a model in memory. */
final class EpsilonRules {

  private final EvlModule module;

  EpsilonRules(EObject root, boolean parallel) throws Exception {
    module = parallel ? new EvlModuleParallelElements() : new EvlModule();
    if (!module.parse(RuleFiles.text("paper.evl"))) {
      throw new IllegalStateException(module.getParseProblems().toString());
    }
    Resource resource = root.eResource();
    if (resource == null) {
      resource = new ResourceImpl();
      resource.getContents().add(root);
    }
    InMemoryEmfModel model =
        new InMemoryEmfModel("M", resource, List.of(root.eClass().getEPackage()));
    model.setCachingEnabled(true);
    module.getContext().getModelRepository().addModel(model);
  }

  int check() throws Exception {
    module.getContext().getUnsatisfiedConstraints().clear();
    return module.execute().size();
  }
}
