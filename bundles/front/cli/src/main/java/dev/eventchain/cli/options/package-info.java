/** Options that several commands share. */
package dev.eventchain.cli.options;
