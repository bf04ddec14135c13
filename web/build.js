// Bundles src/ into inst/. `node build.js --check` fails if a file of inst/ differs from its sources.
//
// The viewer's bundle defines `codendView`; the other bundles import its modules and Preact from there.
import * as esbuild from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const common = {
  bundle: true, minify: true, write: false, format: 'iife', target: 'es2020', charset: 'utf8', legalComments: 'none',
  absWorkingDir: here('.'),
  jsx: 'automatic', jsxImportSource: 'preact'
};

// three.js without its own shaders, except the one chunk that it adds to the viewer's shaders. The table
// of all chunks would add a third of the script's size.
const few_shaders = {
  name: 'few-shaders',
  setup(build) {
    build.onResolve({ filter: /^three$/ }, ({ resolveDir, kind }) =>
      build.resolve('three/src/Three.js', { resolveDir, kind }));
    build.onLoad({ filter: /three\/src\/renderers\/shaders\/ShaderChunk\.js$/ }, ({ path }) => ({
      contents: `import colorspace_pars_fragment from './ShaderChunk/colorspace_pars_fragment.glsl.js';
        export const ShaderChunk = { colorspace_pars_fragment };`, resolveDir: path.replace(/[^/]*$/, '')
    }));
    build.onLoad({ filter: /three\/src\/renderers\/shaders\/ShaderLib\.js$/ }, () => ({
      contents: 'export const ShaderLib = {};'
    }));
  }
};
const viewer_outside = {
  name: 'viewer-outside',
  setup(build) {
    build.onResolve({ filter: /\/view$|^preact/ }, () => ({ path: 'view', namespace: 'outside' }));
    build.onLoad({ filter: /.*/, namespace: 'outside' }, () => ({ contents: 'module.exports = codendView;' }));
  }
};

const bundles = {
  'view/viewer.js': {
    entryPoints: ['src/view/index.ts'], globalName: 'codendView',
    plugins: [few_shaders], banner: { js: licences(['three', 'delaunator', 'fflate', 'preact']) }
  },
  'view/report.js': { entryPoints: ['src/report.ts'] },
  'htmlwidgets/codend.js': { entryPoints: ['src/widget.ts'], plugins: [viewer_outside] },
  'app/tank.css': { entryPoints: ['src/tank/tank.css'] },
  'app/tank.js': {
    entryPoints: ['src/tank/index.ts'], globalName: 'codendTank', plugins: [viewer_outside],
    banner: { js: licences(['fflate']) }
  },
  'share/page.js': { entryPoints: ['src/share/page.ts'] },
  'share/worker.js': { entryPoints: ['src/share/worker.ts'], globalName: 'codendWorker' }
};

function licences(packages) {
  const of_each = packages.map((name) => {
    const folder = here(`node_modules/${name}/`), about = JSON.parse(readFileSync(folder + 'package.json', 'utf8'));
    const address = (about.repository.url ?? about.repository).replace(/\.git$/, '');
    return `${name} ${about.version}, ${address}\n${readFileSync(folder + 'LICENSE', 'utf8').trim()}\n`;
  });
  return `/*! ${of_each.join('\n')}*/`;
}

let outdated = 0;
for (const [target, options] of Object.entries(bundles)) {
  const made = await esbuild.build({ ...common, ...options });
  const text = made.outputFiles[0].text, file = here('../inst/' + target);
  if (!process.argv.includes('--check')) {
    writeFileSync(file, text);
  } else if (readFileSync(file, 'utf8') !== text) {
    console.error(`inst/${target} differs from its sources. Run make web`);
    outdated += 1;
  }
}
process.exitCode = outdated ? 1 : 0;
