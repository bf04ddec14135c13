import tseslint from 'typescript-eslint';

export default tseslint.config(
  ...tseslint.configs.recommended,
  {
    rules: {
      'no-var': 'error', 'prefer-const': ['error', { destructuring: 'all' }], 'prefer-arrow-callback': 'error',
      'object-shorthand': 'error', 'arrow-body-style': 'error', eqeqeq: 'error', 'max-len': ['error', 120]
    }
  }
);
