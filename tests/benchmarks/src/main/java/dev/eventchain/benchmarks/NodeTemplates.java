package dev.eventchain.benchmarks;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;

/** Generates nodes with {@code nodes.mtl}, the template of the paper's appendix C. */
final class NodeTemplates {

  private NodeTemplates() {}

  /** Returns chains whose nodes have one or two inputs, and one output. */
  static EventChain chain(int nodes) {
    EventChain chain = ChainModels.sound(nodes);
    for (int i = 0; i < nodes; i++) {
      SoftwareNode node = chain.getSoftware().get(i);
      node.getOutput().remove(1);
      if (i % 2 == 0) {
        node.getInput().remove(1);
      }
    }
    return chain;
  }

  static TemplateModule compile() {
    return TemplateModule.compile(
        SourceText.of("nodes.mtl", RuleFiles.text("nodes.mtl")),
        name -> Optional.empty(),
        List.of(EventchainPackage.eINSTANCE));
  }

  static GenerationResult generate(TemplateModule module, EventChain chain) {
    return generate(module, chain, GenerationContext.of(element -> SourceLocation.NONE));
  }

  static GenerationResult trace(TemplateModule module, EventChain chain) {
    return generate(
        module, chain, GenerationContext.of(element -> SourceLocation.NONE).withTrace());
  }

  private static GenerationResult generate(
      TemplateModule module, EventChain chain, GenerationContext context) {
    GenerationResult result = module.generate(List.of(chain), context);
    if (!result.diagnostics().isEmpty()) {
      throw new IllegalStateException(result.diagnostics().toString());
    }
    return result;
  }

  /** Returns the first file that differs between two generations; empty if there is none. */
  static Optional<String> difference(
      SortedMap<String, byte[]> one, SortedMap<String, byte[]> other) {
    if (!one.keySet().equals(other.keySet())) {
      return Optional.of("the names");
    }
    return one.keySet().stream()
        .filter(name -> !Arrays.equals(one.get(name), other.get(name)))
        .findFirst();
  }
}
