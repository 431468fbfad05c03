package dev.eventchain.benchmarks;

import dev.eventchain.constraints.OclRules;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.eventchain.EventchainPackage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The rules of the benchmarks. */
final class RuleFiles {

  private RuleFiles() {}

  static String text(String name) {
    try (InputStream stream = RuleFiles.class.getResourceAsStream(name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static OclRules ocl(String name) {
    OclRules rules =
        OclRules.parse(
            List.of(SourceText.of(name, text(name))), List.of(EventchainPackage.eINSTANCE));
    if (!rules.diagnostics().isEmpty()) {
      throw new IllegalStateException(rules.diagnostics().toString());
    }
    return rules;
  }
}
