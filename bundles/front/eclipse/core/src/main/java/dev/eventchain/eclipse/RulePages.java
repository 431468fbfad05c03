package dev.eventchain.eclipse;

import dev.eventchain.diagnostics.RulePage;
import java.io.IOException;
import java.io.InputStream;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.osgi.framework.Bundle;
import org.osgi.framework.FrameworkUtil;

/** Pages about findings, of which each bundle contains its own. */
public final class RulePages {

  private static final List<String> FOLDERS = List.of("META-INF/eventchain/rules/", "rules/");

  private RulePages() {}

  /**
   * Returns the page about a finding, in Markdown.
   *
   * @param id the identifier of the finding
   */
  public static Optional<String> of(String id) {
    if (!id.matches("[a-z0-9.-]+")) {
      return Optional.empty();
    }
    for (Bundle bundle : FrameworkUtil.getBundle(RulePages.class).getBundleContext().getBundles()) {
      for (String folder : FOLDERS) {
        URL page = isOurs(bundle) ? bundle.getEntry(folder + id + ".md") : null;
        if (page != null) {
          return read(page);
        }
      }
    }
    return Optional.empty();
  }

  private static boolean isOurs(Bundle bundle) {
    return String.valueOf(bundle.getSymbolicName()).startsWith("dev.eventchain.");
  }

  /** As {@link #of}, with its id. */
  static Optional<RulePage> page(String id) {
    return of(id).map(text -> new RulePage(id, "", text));
  }

  private static Optional<String> read(URL page) {
    try (InputStream stream = page.openStream()) {
      return Optional.of(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      return Optional.empty(); // the bundle was uninstalled meanwhile
    }
  }
}
