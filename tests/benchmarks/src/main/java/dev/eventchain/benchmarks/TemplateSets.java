package dev.eventchain.benchmarks;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.templates.ShippedTemplates;
import java.util.List;

/** The shipped template sets, compiled as for a project. */
final class TemplateSets {

  private TemplateSets() {}

  static TemplateModule compile(String set) {
    SourceText main = ShippedTemplates.module(set, "main").orElseThrow();
    return TemplateModule.compile(
        main,
        ShippedTemplates.modules(set),
        List.of(EventchainPackage.eINSTANCE, EventChainMetamodel.messages()));
  }
}
