package dev.eventchain.benchmarks;

import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.epsilon.egl.EglTemplate;
import org.eclipse.epsilon.egl.EglTemplateFactory;
import org.eclipse.epsilon.emc.emf.InMemoryEmfModel;

/** {@code node.egl} in Epsilon EGL, parsed once, on a model in memory. */
final class EpsilonTemplate {

  private final EventChain chain;
  private final EglTemplate template;

  EpsilonTemplate(EventChain chain) throws Exception {
    this.chain = chain;
    Resource resource = chain.eResource();
    if (resource == null) {
      resource = new ResourceImpl();
      resource.getContents().add(chain);
    }
    EglTemplateFactory factory = new EglTemplateFactory();
    InMemoryEmfModel model =
        new InMemoryEmfModel("M", resource, List.of(chain.eClass().getEPackage()));
    model.setCachingEnabled(true);
    factory.getContext().getModelRepository().addModel(model);
    template = factory.prepare(RuleFiles.text("node.egl"));
    if (!template.getParseProblems().isEmpty()) {
      throw new IllegalStateException(template.getParseProblems().toString());
    }
  }

  SortedMap<String, byte[]> files() throws Exception {
    SortedMap<String, byte[]> files = new TreeMap<>();
    for (SoftwareNode node : chain.getSoftware()) {
      template.reset();
      template.populate("node", node);
      files.put(NodeFiles.nameOf(node), template.process().getBytes(StandardCharsets.UTF_8));
    }
    return files;
  }
}
